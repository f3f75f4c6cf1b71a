#include <doctest/doctest.h>

#include <GLFW/glfw3.h>

#include <vector>

#include "app/viewer/shell/window.h"

namespace dapple {
namespace {

using Kind = InputEvent::Kind;

InputEvent key(int code, bool down, int modifiers = 0) {
    return {.kind = Kind::key, .code = code, .down = down, .modifiers = modifiers};
}
InputEvent letter(char c) {
    return {.kind = Kind::text, .letter = static_cast<unsigned int>(c)};
}
InputEvent position(double x) {
    return {.kind = Kind::position, .x = x, .y = 0};
}
InputEvent button(bool down) {
    return {.kind = Kind::button, .code = 0, .down = down};
}

/// The events of each frame, if all came before the first.
std::vector<std::size_t> frames(const std::vector<InputEvent>& events) {
    InputQueue queue;
    for (const InputEvent& event : events) queue.push(event);
    std::vector<std::size_t> sizes;
    while (!queue.empty()) sizes.push_back(queue.take_frame().size());
    return sizes;
}

using Sizes = std::vector<std::size_t>;

}  // namespace

TEST_CASE("a key pressed and let go between two frames is down in one of them, with its modifier") {
    CHECK(frames({key(GLFW_KEY_LEFT_CONTROL, true), key(GLFW_KEY_Z, true, GLFW_MOD_CONTROL),
                  key(GLFW_KEY_Z, false), key(GLFW_KEY_LEFT_CONTROL, false)}) == Sizes{2, 2});
}

TEST_CASE(
    "a modifier is down from its own press to its own release, whether or not the system counts it already") {
    for (int counted : {0, GLFW_MOD_CONTROL}) {
        CHECK(modifiers_after(key(GLFW_KEY_RIGHT_CONTROL, true, counted)) == GLFW_MOD_CONTROL);
        CHECK(modifiers_after(key(GLFW_KEY_LEFT_CONTROL, false, counted)) == 0);
    }
    CHECK(modifiers_after(key(GLFW_KEY_E, false, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT)) ==
          (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT));
}

TEST_CASE("letters typed quickly share frames with their keys, and none is lost or comes too early") {
    CHECK(frames({key(GLFW_KEY_1, true), letter('1'), key(GLFW_KEY_2, true), letter('2')}) == Sizes{4});
    CHECK(frames({key(GLFW_KEY_1, true), letter('1'), key(GLFW_KEY_1, false), key(GLFW_KEY_1, true)}) ==
          Sizes{2, 1, 1});
    // GLFW leaves out a key that goes down twice in a millisecond, but not its letters.
    CHECK(frames({key(GLFW_KEY_EQUAL, true), letter('+'), letter('+'), letter('-')}) == Sizes{2, 2});
    // What Enter closes must not see the letter after it.
    CHECK(frames({key(GLFW_KEY_ENTER, true), key(GLFW_KEY_F, true), letter('f')}) == Sizes{1, 2});
    // A backspace is for what was typed before it.
    CHECK(frames({letter('1'), key(GLFW_KEY_BACKSPACE, true), letter('2')}) == Sizes{2, 1});
}

TEST_CASE("a button is pressed where the pointer was then, and of many moves the last one counts") {
    InputQueue queue;
    for (const InputEvent& event : {position(1), position(2), button(true), position(3), button(false)})
        queue.push(event);
    const std::vector<InputEvent> pressed = queue.take_frame();
    REQUIRE(pressed.size() == 2);
    CHECK(pressed[0].x == 2);
    CHECK(pressed[1].down);
    CHECK(queue.take_frame().size() == 2);
    CHECK(queue.empty());
    CHECK(queue.take_frame().empty());
}

TEST_CASE("a click and what is typed into what it opens are two frames") {
    CHECK(frames({button(true), letter('7')}) == Sizes{1, 1});
    CHECK(frames({key(GLFW_KEY_LEFT_CONTROL, true), button(true), key(GLFW_KEY_LEFT_CONTROL, false),
                  button(false)}) == Sizes{2, 2});
}

TEST_CASE("what was typed before a question is forgotten, but keys that were down go up") {
    InputQueue queue;
    for (const InputEvent& event : {key(GLFW_KEY_D, false), key(GLFW_KEY_ENTER, true), letter('d'),
                                    position(3), button(true), key(GLFW_KEY_ENTER, false)})
        queue.push(event);
    queue.forget_typed();
    std::vector<Kind> left;
    while (!queue.empty())
        for (const InputEvent& event : queue.take_frame()) {
            CHECK_FALSE((event.kind == Kind::key && event.down));
            left.push_back(event.kind);
        }
    CHECK(left == std::vector<Kind>{Kind::key, Kind::position, Kind::button, Kind::key});
}

}  // namespace dapple
