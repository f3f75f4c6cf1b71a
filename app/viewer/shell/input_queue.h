#pragma once
// What came from keyboard and mouse, in its order, and how much of it one frame may see.
//
// Dear ImGui looks at what is down when a frame begins. If a frame took long, a key may have gone down and up
// meanwhile, a button been pressed far from where the pointer is now, or a modifier have been let go after
// the key it was for. So a frame is given only as much as it can tell apart, and the next frame the rest.

#include <deque>
#include <vector>

namespace dapple {

/// One of GLFW's events, with the arguments of its callback.
struct InputEvent {
    enum class Kind { focus, enter, position, button, wheel, key, text };
    Kind kind = Kind::position;
    int code = 0;  // of the button or the key; of focus and enter: 1 if it came, 0 if it went
    int scancode = 0;
    bool down = false;  // button, key
    int modifiers = 0;
    double x = 0, y = 0;      // position, wheel
    unsigned int letter = 0;  // text
};

/// GLFW's bits of the modifiers that are down after it, whether or not the system counts the event's own key.
int modifiers_after(const InputEvent& event);

class InputQueue {
 public:
    void push(const InputEvent& event) { events_.push_back(event); }
    bool empty() const { return events_.empty(); }
    /// Leaves out keys that go down, and letters; keys that go up stay, as they may have gone down before.
    void forget_typed();

    /// Takes the events of the next frame, at least one if there are any. Among them no key and no button
    /// changes twice, no letter is typed twice, no modifier changes after something it could be for, the
    /// pointer doesn't move on after a press, and nothing is pressed or typed after a press of a button or of
    /// a key that does something (rather than being a letter).
    std::vector<InputEvent> take_frame();

 private:
    std::deque<InputEvent> events_;
};

}  // namespace dapple
