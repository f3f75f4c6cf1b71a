#include "app/viewer/shell/window.h"

#include <epoxy/gl.h>
// epoxy before GLFW
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <stb_image.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <glm/common.hpp>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/widgets.h"
#include "dapple_assets_embedded/assets.h"

namespace dapple {

namespace {

using EventKind = InputEvent::Kind;

/// The bit of the modifier that the event's key is; 0: it is none.
int modifier_of(const InputEvent& event) {
    // Left ones, then right ones, each in the order of their bits.
    static_assert(GLFW_KEY_RIGHT_SUPER == GLFW_KEY_LEFT_SHIFT + 7 && GLFW_MOD_SUPER == GLFW_MOD_SHIFT << 3);
    const bool is_one = event.code >= GLFW_KEY_LEFT_SHIFT && event.code <= GLFW_KEY_RIGHT_SUPER;
    return event.kind == EventKind::key && is_one ? 1 << (event.code - GLFW_KEY_LEFT_SHIFT) % 4 : 0;
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

bool is_within_reach(const Rectangle<int>& window, std::span<const Rectangle<int>> screens) {
    constexpr int kHold = 40;
    return std::ranges::any_of(screens, [&](const Rectangle<int>& screen) {
        return window.high.x >= screen.low.x + kHold && window.low.x <= screen.high.x - kHold &&
               window.low.y >= screen.low.y && window.low.y <= screen.high.y - kHold;
    });
}

std::size_t screen_under(const Rectangle<int>& window, std::span<const Rectangle<int>> screens) {
    std::size_t best = 0;
    std::int64_t most = 0;
    for (std::size_t i = 0; i < screens.size(); ++i) {
        const glm::ivec2 shared = glm::max(
            glm::min(window.high, screens[i].high) - glm::max(window.low, screens[i].low), glm::ivec2(0));
        const std::int64_t area = std::int64_t{shared.x} * shared.y;
        if (area <= most) continue;
        most = area;
        best = i;
    }
    return best;
}

namespace {

constexpr int kDefaultWidth = 1280, kDefaultHeight = 800;
constexpr int kSmallestWidth = 640, kSmallestHeight = 400;  // at 96 dpi

// After a pointer has come to rest there is another frame: what it rests on may have something to say.
constexpr double kPointerRests = 0.6;  // seconds
constexpr double kLongestWait = 3600;
constexpr std::chrono::milliseconds kLongestUnseen(100);
// The scale of text. A system that says more is mistaken, and ImGui's picture of all letters would not fit.
constexpr float kSmallestScale = 0.5f, kLargestScale = 8;

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

// GLFW's way of waking has no memory: what comes while events are only polled is gone with them.
std::atomic<bool> woken = false;

Window& window_of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

Rectangle<int> rectangle(int x, int y, int width, int height) {
    return {{x, y}, {x + width, y + height}};
}

std::span<GLFWmonitor* const> monitors() {
    int count = 0;
    GLFWmonitor** const first = glfwGetMonitors(&count);
    return {first, static_cast<std::size_t>(count)};
}

/// Without the desktop's own bars.
std::vector<Rectangle<int>> work_areas() {
    std::vector<Rectangle<int>> areas;
    for (GLFWmonitor* const monitor : monitors()) {
        int x = 0, y = 0, width = 0, height = 0;
        glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
        areas.push_back(rectangle(x, y, width, height));
    }
    return areas;
}

/// Null: there is none.
GLFWmonitor* monitor_under(GLFWwindow* window) {
    int x = 0, y = 0, width = 0, height = 0;
    glfwGetWindowPos(window, &x, &y);
    glfwGetWindowSize(window, &width, &height);
    std::vector<Rectangle<int>> screens;
    for (GLFWmonitor* const monitor : monitors()) {
        const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
        glm::ivec2 corner{0};
        glfwGetMonitorPos(monitor, &corner.x, &corner.y);
        screens.push_back(rectangle(corner.x, corner.y, mode ? mode->width : 0, mode ? mode->height : 0));
    }
    return screens.empty() ? nullptr : monitors()[screen_under(rectangle(x, y, width, height), screens)];
}

void clear_around(const Rectangle<int>& hole, glm::ivec2 window) {
    const glm::vec3 colour = rgb_of(ThemeColour::surround);
    glClearColor(colour.r, colour.g, colour.b, 1);
    const glm::ivec2 low = glm::clamp(hole.low, glm::ivec2(0), window),
                     high = glm::clamp(hole.high, low, window);
    glEnable(GL_SCISSOR_TEST);
    for (const Rectangle<int>& part : {rectangle(0, 0, window.x, low.y),
                                       {{0, high.y}, window},
                                       {{0, low.y}, {low.x, high.y}},
                                       {{high.x, low.y}, {window.x, high.y}}}) {
        const glm::ivec2 size = part.size();
        if (size.x <= 0 || size.y <= 0) continue;
        glScissor(part.low.x, window.y - part.high.y, size.x, size.y);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
}

// The built-in one, in the sizes that desktops ask for.
void set_window_icon(GLFWwindow* window) {
    std::vector<std::unique_ptr<stbi_uc, decltype(&stbi_image_free)>> pixels;
    std::vector<GLFWimage> icons;
    for (std::string_view png : {assets::icon_16_png(), assets::icon_32_png(), assets::icon_64_png()}) {
        GLFWimage icon{};
        icon.pixels =
            stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()),
                                  &icon.width, &icon.height, nullptr, 4);
        if (!icon.pixels) continue;
        pixels.emplace_back(icon.pixels, &stbi_image_free);
        icons.push_back(icon);
    }
    glfwSetWindowIcon(window, static_cast<int>(icons.size()), icons.data());
}

void put_where_it_was(GLFWwindow* window, const WindowPlace& place) {
    if (place.width < kSmallestWidth || place.height < kSmallestHeight ||
        !is_within_reach(rectangle(place.x, place.y, place.width, place.height), work_areas()))
        return;
    glfwSetWindowSize(window, place.width, place.height);
    glfwSetWindowPos(window, place.x, place.y);
    if (place.maximised) glfwMaximizeWindow(window);
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

Window::Window(const std::string& title, const WindowPlace& place)
    : library_(std::make_unique<Library>()), place_(place) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
#ifdef __APPLE__
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
#endif
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    // As packaging/dapple.desktop is called, so that a desktop knows the window's icon.
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "dapple");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "dapple");
    window_ = glfwCreateWindow(kDefaultWidth, kDefaultHeight, title.c_str(), nullptr, nullptr);
    if (!window_)
        throw std::runtime_error("no window with OpenGL 3.3 can be opened (" + glfw_says() +
                                 "); `dapple render` draws into a file without one");
    put_where_it_was(window_, place);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    hear();
    set_window_icon(window_);

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
#if IMGUI_VERSION_NUM >= 18700
    prepare_input();  // earlier its part for GLFW does
#endif
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
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
    return glfwWindowShouldClose(window_) && input_.empty();
}
void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}
void Window::stay_open() {
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
}
void Window::set_title(const std::string& title) {
    if (std::exchange(title_, title) != title) glfwSetWindowTitle(window_, title.c_str());
}

void Window::toggle_full_screen() {
    if (glfwGetWindowMonitor(window_)) {
        glfwSetWindowMonitor(window_, nullptr, windowed_corner_.x, windowed_corner_.y, windowed_size_.x,
                             windowed_size_.y, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = monitor_under(window_);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    glfwGetWindowPos(window_, &windowed_corner_.x, &windowed_corner_.y);
    glfwGetWindowSize(window_, &windowed_size_.x, &windowed_size_.y);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

WindowPlace Window::place() const {
    place_.maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
    const bool full = glfwGetWindowMonitor(window_) != nullptr;
    if (full) {
        place_.x = windowed_corner_.x, place_.y = windowed_corner_.y;
        place_.width = windowed_size_.x, place_.height = windowed_size_.y;
    } else if (!place_.maximised && glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_FALSE) {
        glfwGetWindowPos(window_, &place_.x, &place_.y);
        glfwGetWindowSize(window_, &place_.width, &place_.height);
    }
    return place_;
}

bool Window::wait_for_events(double seconds) {
    using Clock = std::chrono::steady_clock;
    bool early = woken.exchange(false);
    if (seconds > 0 && !early) {
        const std::chrono::duration<double> since_move = Clock::now() - pointer_moved_;
        const double to_tip = kPointerRests - since_move.count();
        const double wait = std::min({seconds, to_tip > 0 ? to_tip : seconds, kLongestWait});
        const auto end = Clock::now() + std::chrono::duration<double>(wait);
        glfwWaitEventsTimeout(wait);
        early = woken.exchange(false) || Clock::now() < end || wait == to_tip;
    } else {
        glfwPollEvents();
    }
    return std::exchange(damaged_, false) || early || input_waits() || !dropped_.empty();
}

void Window::wake() {
    woken = true;
    glfwPostEmptyEvent();
}

std::vector<std::filesystem::path> Window::take_dropped() {
    if (!input_.empty()) return {};
    return std::exchange(dropped_, {});
}

std::string Window::clipboard_text() const {
    const char* const text = glfwGetClipboardString(window_);
    return text ? text : "";
}

void Window::follow_content_scale() {
    float scale = 1, ignored = 1;
    glfwGetWindowContentScale(window_, &scale, &ignored);
    // Where the system itself enlarges (macOS), points are not pixels and the text must not grow twice.
    scale = std::clamp(scale / static_cast<float>(pixels_per_point().x), kSmallestScale, kLargestScale);
    if (scale == content_scale_ && appearance_ == applied_) return;
    bool again = content_scale_ > 0;
    content_scale_ = scale;
    applied_ = appearance_;
    apply_theme(appearance_, scale);
    const auto scaled = [&](int size) { return static_cast<int>(static_cast<float>(size) * content_scale_); };
    glfwSetWindowSizeLimits(window_, scaled(kSmallestWidth), scaled(kSmallestHeight), GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
    if (again) {
#if IMGUI_VERSION_NUM < 19200  // later it follows by itself
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
    }
}

void Window::forget_typed() {
    glfwPollEvents();
    input_.forget_typed();
}

bool Window::input_waits() const {
    return !input_.empty();
}

void Window::hear() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        auto& dropped = window_of(window).dropped_;
        dropped.insert(dropped.end(), paths, paths + count);
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { window_of(window).damaged_ = true; });
    glfwSetFramebufferSizeCallback(window_,
                                   [](GLFWwindow* window, int, int) { window_of(window).damaged_ = true; });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int came) {
        window_of(window).input_.push({.kind = EventKind::focus, .code = came});
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int came) {
        window_of(window).input_.push({.kind = EventKind::enter, .code = came});
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        window_of(window).input_.push({.kind = EventKind::position, .x = x, .y = y});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int modifiers) {
        window_of(window).input_.push({.kind = EventKind::button,
                                       .code = button,
                                       .down = action == GLFW_PRESS,
                                       .modifiers = modifiers});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
        window_of(window).input_.push({.kind = EventKind::wheel, .x = x, .y = y});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
        if (action == GLFW_REPEAT || key == GLFW_KEY_UNKNOWN) return;  // ImGui repeats keys itself
        window_of(window).input_.push({.kind = EventKind::key,
                                       .code = printed_key(key, scancode),
                                       .scancode = scancode,
                                       .down = action == GLFW_PRESS,
                                       .modifiers = modifiers});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int letter) {
        window_of(window).input_.push({.kind = EventKind::text, .letter = letter});
    });
    glfwGetCursorPos(window_, &pointer_.x, &pointer_.y);
}

void Window::feed(const InputEvent& event) {
    switch (event.kind) {
        case EventKind::focus:
            return ImGui_ImplGlfw_WindowFocusCallback(window_, event.code);
        case EventKind::enter:
            return ImGui_ImplGlfw_CursorEnterCallback(window_, event.code);
        case EventKind::position:
            pointer_ = {event.x, event.y};
            pointer_moved_ = std::chrono::steady_clock::now();
#if IMGUI_VERSION_NUM >= 18700
            ImGui_ImplGlfw_CursorPosCallback(window_, event.x, event.y);
#endif
            return;
        case EventKind::text:
            return ImGui::GetIO().AddInputCharacter(event.letter);
#if IMGUI_VERSION_NUM < 18700
        case EventKind::button:
            if (event.code >= 0 && event.code < static_cast<int>(buttons_.size()))
                buttons_[static_cast<std::size_t>(event.code)] = event.down;
            return ImGui_ImplGlfw_MouseButtonCallback(
                window_, event.code, event.down ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
        case EventKind::wheel:
            return ImGui_ImplGlfw_ScrollCallback(window_, event.x, event.y);
        case EventKind::key:
            return ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode,
                                              event.down ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
#else
        // Not by ImGui's part for GLFW: that asks which modifiers are down now, which is too late.
        case EventKind::button:
            put_modifiers(modifiers_after(event));
            if (event.code < ImGuiMouseButton_COUNT)
                ImGui::GetIO().AddMouseButtonEvent(event.code, event.down);
            return;
        case EventKind::wheel:
            return ImGui::GetIO().AddMouseWheelEvent(static_cast<float>(event.x),
                                                     static_cast<float>(event.y));
        case EventKind::key:
            put_modifiers(modifiers_after(event));
            if (const ImGuiKey key = imgui_key(event.code)) ImGui::GetIO().AddKeyEvent(key, event.down);
            return;
#endif
    }
}

void Window::begin_frame() {
    follow_content_scale();
    for (const InputEvent& event : input_.take_frame()) feed(event);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
#if IMGUI_VERSION_NUM < 18700
    // It asked GLFW where the mouse is now, which may be further than this frame is to know.
    ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsMousePosValid(&io.MousePos))
        io.MousePos = {static_cast<float>(pointer_.x), static_cast<float>(pointer_.y)};
    for (std::size_t button = 0; button < std::min(buttons_.size(), std::size(io.MouseDown)); ++button)
        io.MouseDown[button] = buttons_[button];
#endif
    new_frame();
    unseen_ = input_waits() && std::chrono::steady_clock::now() - seen_ < kLongestUnseen;
}

void Window::end_frame() {
    if (unseen_) return ImGui::EndFrame();
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glm::ivec2 size = pixels();
    glViewport(0, 0, size.x, size.y);
    clear_around(std::exchange(left_out_, {}), size);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
    seen_ = std::chrono::steady_clock::now();
}

int Window::gl_errors() {
    constexpr int kMost = 100;  // a lost context says so again and again
    int count = 0;
    for (GLenum error = glGetError(); count < kMost && error != GL_NO_ERROR; error = glGetError(), ++count)
        std::fprintf(stderr, "dapple: OpenGL error 0x%04x, framebuffer status 0x%04x\n", error,
                     glCheckFramebufferStatus(GL_FRAMEBUFFER));
    return count;
}

glm::ivec2 Window::pixels() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::dvec2 Window::pixels_per_point() const {
    // The system is asked for either size at that moment, so a window that is just being resized would give
    // any ratio: asked until nothing changed between.
    const auto points = [&] {
        glm::ivec2 size{0};
        glfwGetWindowSize(window_, &size.x, &size.y);
        return size;
    };
    glm::ivec2 before = points(), framebuffer = pixels();
    for (glm::ivec2 now = points(); now != before; now = points()) {
        before = now;
        framebuffer = pixels();
    }
    if (before.x <= 0 || before.y <= 0 || framebuffer.x <= 0 || framebuffer.y <= 0) return {1, 1};
    return glm::dvec2(framebuffer) / glm::dvec2(before);
}

}  // namespace dapple
