#include <doctest/doctest.h>

#include "app/viewer/model/history.h"

namespace dapple {

TEST_CASE("a drag is one step to undo") {
    History<int> history(1);
    for (int value = 2; value < 10; ++value) history.observe(value, true);
    history.observe(9, false);
    CHECK(history.undo() == 1);
    CHECK(history.redo() == 9);
}

TEST_CASE("undo stops at the first value and redo at the last") {
    History<int> history(1);
    history.observe(2, false);
    history.observe(3, false);
    CHECK(history.undo() == 2);
    CHECK(history.undo() == 1);
    CHECK_FALSE(history.can_undo());
    CHECK(history.undo() == 1);
    CHECK(history.redo() == 2);
    CHECK(history.redo() == 3);
    CHECK_FALSE(history.can_redo());
    CHECK(history.redo() == 3);
}

TEST_CASE("what was undone is forgotten once something else is done") {
    History<int> history(1);
    history.observe(2, false);
    history.undo();
    history.observe(7, false);
    CHECK_FALSE(history.can_redo());
    CHECK(history.undo() == 1);
    CHECK(history.redo() == 7);
}

TEST_CASE("seeing the value that undo gave back is no new step") {
    History<int> history(1);
    history.observe(2, false);
    history.observe(history.undo(), false);
    CHECK(history.can_redo());
}

}  // namespace dapple
