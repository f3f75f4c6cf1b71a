#include "core/drawing/pipeline.h"

#include <doctest/doctest.h>

#include <memory>

namespace dapple {

TEST_CASE("a kept value is made again for another key alone, once the one before is given up") {
    Cached<int, std::shared_ptr<int>> cached;
    std::weak_ptr<int> before;
    int made = 0;
    const auto make = [&] {
        CHECK(before.expired());
        return std::make_shared<int>(++made);
    };
    CHECK(*cached.of(7, make) == 1);
    CHECK(*cached.of(7, make) == 1);
    before = cached.value();
    CHECK(cached.find(8) == nullptr);
    CHECK(*cached.of(8, make) == 2);
    CHECK(cached.find(7) == nullptr);
    before = cached.value();
    cached.forget();
    CHECK(before.expired());
    CHECK(*cached.of(8, make) == 3);
    cached.keep(9, nullptr);
    CHECK(*cached.find(9) == nullptr);
}

}  // namespace dapple
