#pragma once
// Undo for anything that is one value.

#include <cstddef>
#include <utility>
#include <vector>

namespace dapple {

template <class Value>
class History {
 public:
    explicit History(Value first) : kept_{std::move(first)} {}

    /// To be told the value each frame. Keeps it once the person has let go of what they were editing, so
    /// that a slider's drag is one step.
    void observe(const Value& now, bool editing) {
        if (editing || now == kept_[at_]) return;
        kept_.resize(at_ + 1);
        kept_.push_back(now);
        if (kept_.size() > kMostSteps) kept_.erase(kept_.begin());
        at_ = kept_.size() - 1;
    }

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < kept_.size(); }

    /// The value one step back or forward; the present one at either end.
    const Value& undo() { return kept_[can_undo() ? --at_ : at_]; }
    const Value& redo() { return kept_[can_redo() ? ++at_ : at_]; }

 private:
    static constexpr std::size_t kMostSteps = 500;
    std::vector<Value> kept_;
    std::size_t at_ = 0;
};

}  // namespace dapple
