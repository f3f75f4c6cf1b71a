#pragma once
// The desktop's window with its OpenGL context and Dear ImGui in it.

#include <array>
#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/viewer/shell/memory.h"
#include "app/viewer/widgets/theme.h"
#include "core/image/rectangle.h"

struct GLFWwindow;

namespace dapple {

// What came from keyboard and mouse, in its order, and how much of it one frame may see.
//
// Dear ImGui looks at what is down when a frame begins. If a frame took long, a key may have gone down and up
// meanwhile, a button been pressed far from where the pointer is now, or a modifier have been let go after
// the key it was for. So a frame is given only as much as it can tell apart, and the next frame the rest.

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

// Where a window lies among the screens of a desktop, all in the desktop's units.

/// Whether a person can take hold of the window by its title bar, of which a part is on some screen.
bool is_within_reach(const Rectangle<int>& window, std::span<const Rectangle<int>> screens);

/// Which screen most of the window is on; the first where it is on none.
std::size_t screen_under(const Rectangle<int>& window, std::span<const Rectangle<int>> screens);

class Window {
 public:
    /// Opens it. Throws std::runtime_error if there is no display or no OpenGL 3.3.
    /// Without a place, or with one that is on no screen any more, it is the usual one.
    explicit Window(const std::string& title, const WindowPlace& place = {});
    ~Window();
    Window& operator=(Window&&) = delete;

    /// It was asked to, and what was typed and clicked before that has been seen.
    bool should_close() const;
    void close();
    /// Although it was to be closed.
    void stay_open();
    void set_title(const std::string& title);
    void toggle_full_screen();
    /// Where it is, or was before it filled the screen.
    WindowPlace place() const;
    /// From the next frame on.
    void set_appearance(const Appearance& appearance) { appearance_ = appearance; }

    /// Sleeps until something happens or the time is over; 0 returns at once. False: nothing happened.
    bool wait_for_events(double seconds);
    /// There is input that the last frame was not given: the next one has to follow at once.
    bool input_waits() const;
    /// What was typed until now is not for what the next frames show.
    void forget_typed();
    /// This frame need not be seen, nor drawn: the next follows at once. Where drawing is slow, input would
    /// wait for long otherwise.
    bool frame_is_unseen() const { return unseen_; }
    /// Ends another thread's wait_for_events(), the next one if none is under way: it then returns true.
    static void wake();

    /// Files dropped on the window since the last call, once what was typed and clicked before has been seen.
    std::vector<std::filesystem::path> take_dropped();

    /// Its text; empty if it has none.
    std::string clipboard_text() const;

    void begin_frame();
    /// All these pixels of this frame, from the upper left corner, come from somebody else: they get no
    /// colour before, which where OpenGL is a program takes as long as the rest of the window.
    void leave_out(const Rectangle<int>& pixels) { left_out_ = pixels; }
    /// Draws ImGui's part and shows the frame, unless it is one that need not be seen.
    void end_frame();

    /// How many errors OpenGL had since the last call; standard error says which. Waits for OpenGL: for
    /// tests.
    static int gl_errors();

    glm::ivec2 pixels() const;  // of the framebuffer
    /// ImGui's units (the mouse's) to framebuffer pixels.
    glm::dvec2 pixels_per_point() const;
    /// As the desktop has it: 96 at content scale 1.
    double pixels_per_inch() const { return 96 * double{content_scale_} * pixels_per_point().x; }

 private:
    struct Library;  // GLFW itself
    void follow_content_scale();
    void hear();
    void feed(const InputEvent& event);

    std::unique_ptr<Library> library_;
    GLFWwindow* window_ = nullptr;
    std::string title_;
    std::vector<std::filesystem::path> dropped_;
    InputQueue input_;
    // As far as ImGui has heard.
    glm::dvec2 pointer_{0};
    std::chrono::steady_clock::time_point pointer_moved_{};
    std::array<bool, 8> buttons_{};  // as many as GLFW has
    bool unseen_ = false;
    std::chrono::steady_clock::time_point seen_{};  // the last frame that was
    Rectangle<int> left_out_{};
    bool damaged_ = false;       // to be drawn again, whatever the reason
    mutable WindowPlace place_;  // while it was neither full screen nor maximised
    float content_scale_ = 0;
    Appearance appearance_, applied_;
    glm::ivec2 windowed_corner_{0}, windowed_size_{0};
};

}  // namespace dapple
