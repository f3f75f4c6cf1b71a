#pragma once
// The desktop's window with its OpenGL context and Dear ImGui in it.

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace dapple {

class Window {
 public:
    /// Opens it. Throws std::runtime_error if there is no display or no OpenGL 3.3.
    explicit Window(const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool should_close() const;
    void close();
    void set_title(const std::string& title);
    void toggle_full_screen();

    /// Sleeps until something happens or the time is over, at most a second; 0 returns at once.
    void wait_for_events(double seconds);
    /// Ends another thread's wait_for_events().
    static void wake();

    /// Files dropped on the window since the last call.
    std::vector<std::filesystem::path> take_dropped();

    void begin_frame();
    /// Draws ImGui's part and shows the frame.
    void end_frame();

    glm::ivec2 pixels() const;  // of the framebuffer
    /// ImGui's units (the mouse's) to framebuffer pixels.
    glm::dvec2 pixels_per_point() const;

 private:
    struct Library;  // GLFW itself
    void follow_content_scale();
    void set_smallest_size();
    void show_short_presses();
    void forget_short_presses();
    void show_press_positions();

    std::unique_ptr<Library> library_;
    GLFWwindow* window_ = nullptr;
    std::vector<std::filesystem::path> dropped_;
    struct KeyPress {
        int key = 0, modifiers = 0;
    };
    std::vector<KeyPress> pressed_;   // since the last frame
    std::vector<int> short_presses_;  // of them, those let go already
    // In the order of the events: where the pointer was last, and where each button went down in this frame.
    glm::dvec2 pointer_{0};
    struct ButtonPress {
        int button = 0, modifiers = 0;
        glm::dvec2 place{0};
    };
    std::vector<ButtonPress> button_presses_;
    float content_scale_ = 0;
    glm::ivec2 windowed_corner_{0}, windowed_size_{0};
};

}  // namespace dapple
