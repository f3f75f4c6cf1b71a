#pragma once
// The desktop's window with its OpenGL context and Dear ImGui in it.

#include <array>
#include <chrono>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/viewer/shell/input_queue.h"
#include "app/viewer/shell/memory.h"
#include "app/viewer/widgets/theme.h"
#include "core/image/rectangle.h"

struct GLFWwindow;

namespace dapple {

class Window {
 public:
    /// Opens it. Throws std::runtime_error if there is no display or no OpenGL 3.3.
    /// Without a place, or with one that is on no screen any more, it is the usual one.
    explicit Window(const std::string& title, const WindowPlace& place = {});
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

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
    void set_smallest_size();
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
