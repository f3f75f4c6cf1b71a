#include "app/viewer/shell/input_queue.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace dapple {
namespace {

using EventKind = InputEvent::Kind;

/// The bit of the modifier that the event's key is; 0: it is none.
int modifier_of(const InputEvent& event) {
    if (event.kind != EventKind::key) return 0;
    switch (event.code) {
        case GLFW_KEY_LEFT_SHIFT:
        case GLFW_KEY_RIGHT_SHIFT:
            return GLFW_MOD_SHIFT;
        case GLFW_KEY_LEFT_CONTROL:
        case GLFW_KEY_RIGHT_CONTROL:
            return GLFW_MOD_CONTROL;
        case GLFW_KEY_LEFT_ALT:
        case GLFW_KEY_RIGHT_ALT:
            return GLFW_MOD_ALT;
        case GLFW_KEY_LEFT_SUPER:
        case GLFW_KEY_RIGHT_SUPER:
            return GLFW_MOD_SUPER;
        default:
            return 0;
    }
}

bool is_modifier(const InputEvent& event) {
    return modifier_of(event) != 0;
}

/// A letter that is pressed with Ctrl does something too.
bool does_something(const InputEvent& event) {
    if (event.kind == EventKind::button) return event.down;
    if (event.kind != EventKind::key || !event.down || is_modifier(event)) return false;
    const bool letter = event.code >= GLFW_KEY_SPACE && event.code <= GLFW_KEY_GRAVE_ACCENT;
    return !letter || (event.modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER | GLFW_MOD_ALT));
}

/// Looked at together with the modifiers.
bool is_modified(const InputEvent& event) {
    return (event.kind == EventKind::key && event.down && !is_modifier(event)) ||
           event.kind == EventKind::wheel || (event.kind == EventKind::button && event.down);
}

/// Whether one frame can tell what is meant by both.
bool fit_together(const InputEvent& earlier, const InputEvent& later) {
    const bool same_switch = (later.kind == EventKind::key || later.kind == EventKind::button) &&
                             earlier.kind == later.kind && earlier.code == later.code;
    if (same_switch) return false;
    // Keys are also known by what they type, once in a frame.
    if (later.kind == EventKind::text && earlier.kind == EventKind::text && earlier.letter == later.letter)
        return false;
    if (is_modifier(later) && is_modified(earlier)) return false;
    switch (later.kind) {
        case EventKind::focus:
            return false;  // ImGui forgets then what is down
        case EventKind::enter:
        case EventKind::position:
            return earlier.kind != EventKind::button && earlier.kind != EventKind::wheel;
        case EventKind::button:
            return earlier.kind != EventKind::wheel && !does_something(earlier) &&
                   earlier.kind != EventKind::text;
        case EventKind::wheel:
            return earlier.kind != EventKind::button;
        case EventKind::key:
        case EventKind::text:
            return !does_something(earlier) && earlier.kind != EventKind::focus;
    }
    return true;
}

}  // namespace

int modifiers_after(const InputEvent& event) {
    const int own = modifier_of(event);
    return event.down ? event.modifiers | own : event.modifiers & ~own;
}

void InputQueue::forget_typed() {
    std::erase_if(events_, [](const InputEvent& event) {
        return event.kind == EventKind::text || (event.kind == EventKind::key && event.down);
    });
}

std::vector<InputEvent> InputQueue::take_frame() {
    std::vector<InputEvent> frame;
    while (!events_.empty()) {
        const InputEvent& next = events_.front();
        if (!std::ranges::all_of(frame, [&](const InputEvent& e) { return fit_together(e, next); })) break;
        // Only the last of many moves counts.
        if (next.kind == EventKind::position && !frame.empty() && frame.back().kind == EventKind::position)
            frame.pop_back();
        frame.push_back(next);
        events_.pop_front();
    }
    return frame;
}

}  // namespace dapple
