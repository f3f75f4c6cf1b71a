#include "app/viewer/analyst.h"

#include <cassert>
#include <exception>
#include <utility>

namespace dapple {

bool Analyst::busy() const {
    std::scoped_lock lock(mutex_);
    return busy_;
}

void Analyst::begin(ViewAnalysisRequest request) {
    {
        std::scoped_lock lock(mutex_);
        assert(!busy_);
        busy_ = true;
        result_.reset();
    }
    thread_ = std::jthread([this, request = std::move(request)](std::stop_token stop) mutable {
        run(std::move(request), stop);
    });
}

std::optional<ViewAnalysis> Analyst::result() {
    std::scoped_lock lock(mutex_);
    return std::exchange(result_, std::nullopt);
}

void Analyst::run(ViewAnalysisRequest request, const std::stop_token& stop) {
    std::optional<ViewAnalysis> result;
    try {
        result = analyse_view(std::move(request), stop);
    } catch (const std::exception& error) {
        result.emplace().error = error.what();
    }
    {
        std::scoped_lock lock(mutex_);
        busy_ = false;
        result_ = std::move(result);
    }
    wake_();
}

}  // namespace dapple
