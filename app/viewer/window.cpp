#include <epoxy/gl.h>
// epoxy before GLFW
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/viewer/theme.h"
#include "app/viewer/window.h"
#include "app/viewer/window_icon.h"

namespace dapple {
namespace {

constexpr int kDefaultWidth = 1280, kDefaultHeight = 800;
constexpr int kSmallestWidth = 640, kSmallestHeight = 400;  // at 96 dpi
// Seconds. A graphics driver's thread may read the event for which this one sleeps; then nothing else wakes
// it.
constexpr double kLongestWait = 1;

std::string glfw_says() {
    const char* words = nullptr;
    glfwGetError(&words);
    return words ? words : "no reason given";
}

/// GLFW names keys by their place on an American keyboard; people go by what is printed on them.
int printed_key(int key, int scancode) {
    if (key < GLFW_KEY_SPACE || key > GLFW_KEY_GRAVE_ACCENT) return key;
    const char* name = glfwGetKeyName(key, scancode);
    if (!name || name[0] == 0 || name[1] != 0) return key;
    if (name[0] >= 'a' && name[0] <= 'z') return name[0] - 'a' + GLFW_KEY_A;
    if (name[0] >= '0' && name[0] <= '9') return name[0];
    return key;
}

void read_modifiers() {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
}

}  // namespace

struct Window::Library {
    Library() {
        if (!glfwInit())
            throw std::runtime_error("no window can be opened (" + glfw_says() +
                                     "); `dapple render` draws into a file without one");
    }
    ~Library() { glfwTerminate(); }
};

Window::Window(const std::string& title) : library_(std::make_unique<Library>()) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
#ifdef __APPLE__
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
#endif
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window_ = glfwCreateWindow(kDefaultWidth, kDefaultHeight, title.c_str(), nullptr, nullptr);
    if (!window_)
        throw std::runtime_error("no window with OpenGL 3.3 can be opened (" + glfw_says() +
                                 "); `dapple render` draws into a file without one");
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        auto* self = static_cast<Window*>(glfwGetWindowUserPointer(window));
        self->dropped_.insert(self->dropped_.end(), paths, paths + count);
    });

    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
        auto* self = static_cast<Window*>(glfwGetWindowUserPointer(window));
        if (action == GLFW_PRESS && key != GLFW_KEY_UNKNOWN)
            self->pressed_.push_back({printed_key(key, scancode), modifiers});
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        static_cast<Window*>(glfwGetWindowUserPointer(window))->pointer_ = {x, y};
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int modifiers) {
        auto* self = static_cast<Window*>(glfwGetWindowUserPointer(window));
        if (action == GLFW_PRESS) self->button_presses_.push_back({button, modifiers, self->pointer_});
    });
    set_window_icon(window_);

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    follow_content_scale();
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
}

bool Window::should_close() const {
    return glfwWindowShouldClose(window_);
}
void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}
void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::toggle_full_screen() {
    if (glfwGetWindowMonitor(window_)) {
        glfwSetWindowMonitor(window_, nullptr, windowed_corner_.x, windowed_corner_.y, windowed_size_.x,
                             windowed_size_.y, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    glfwGetWindowPos(window_, &windowed_corner_.x, &windowed_corner_.y);
    glfwGetWindowSize(window_, &windowed_size_.x, &windowed_size_.y);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::wait_for_events(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(std::min(seconds, kLongestWait));
    else
        glfwPollEvents();
}

void Window::wake() {
    glfwPostEmptyEvent();
}

std::vector<std::filesystem::path> Window::take_dropped() {
    return std::exchange(dropped_, {});
}

void Window::follow_content_scale() {
    float scale = 1, ignored = 1;
    glfwGetWindowContentScale(window_, &scale, &ignored);
    // Where the system itself enlarges (macOS), points are not pixels and the text must not grow twice.
    scale = std::max(0.5f, scale / static_cast<float>(pixels_per_point().x));
    if (scale == content_scale_) return;
    bool again = content_scale_ > 0;
    content_scale_ = scale;
    apply_theme(scale);
    set_smallest_size();
    if (again) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
}

void Window::set_smallest_size() {
    const auto scaled = [&](int size) { return static_cast<int>(static_cast<float>(size) * content_scale_); };
    glfwSetWindowSizeLimits(window_, scaled(kSmallestWidth), scaled(kSmallestHeight), GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
}

// A key pressed and let go between two frames, which a slow frame makes likely, would go unseen: ImGui 1.86
// looks at what is down at a frame's beginning. Such keys, and the modifiers they were pressed with, are held
// down for one frame.
void Window::show_short_presses() {
    ImGuiIO& io = ImGui::GetIO();
    const auto hold_modifiers = [&](int modifiers) {
        if (modifiers & GLFW_MOD_CONTROL) io.KeyCtrl = true;
        if (modifiers & GLFW_MOD_SHIFT) io.KeyShift = true;
    };
    for (const ButtonPress& press : button_presses_) hold_modifiers(press.modifiers);
    for (const KeyPress& press : pressed_) {
        hold_modifiers(press.modifiers);
        if (io.KeysDown[press.key]) continue;
        io.KeysDown[press.key] = true;
        short_presses_.push_back(press.key);
    }
}

void Window::forget_short_presses() {
    const bool none = pressed_.empty() && button_presses_.empty();
    pressed_.clear();
    button_presses_.clear();
    if (none) return;
    for (int key : std::exchange(short_presses_, {})) ImGui::GetIO().KeysDown[key] = false;
    read_modifiers();
}

// ImGui 1.86 takes the pointer's place at the frame's beginning for that of a press, which after a slow frame
// is wherever the pointer has come meanwhile.
void Window::show_press_positions() {
    for (const auto& [button, modifiers, place] : button_presses_)
        if (button < ImGuiMouseButton_COUNT && ImGui::IsMouseClicked(button))
            ImGui::GetIO().MouseClickedPos[button] = {static_cast<float>(place.x),
                                                      static_cast<float>(place.y)};
}

void Window::begin_frame() {
    follow_content_scale();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    show_short_presses();
    ImGui::NewFrame();
    show_press_positions();
}

void Window::end_frame() {
    forget_short_presses();
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glm::ivec2 size = pixels();
    glViewport(0, 0, size.x, size.y);
    glm::vec3 desk = rgb_of(ThemeColour::surround);
    glClearColor(desk.r, desk.g, desk.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

glm::ivec2 Window::pixels() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::dvec2 Window::pixels_per_point() const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (width <= 0 || height <= 0) return {1, 1};
    return glm::dvec2(pixels()) / glm::dvec2(width, height);
}

}  // namespace dapple
