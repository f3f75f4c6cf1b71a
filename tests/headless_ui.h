#pragma once
// Panels without a window: Dear ImGui with a mouse that tests move.

#include <imgui.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

// Input, between frames, as the window gives it.

inline void put_key(Key key, bool down) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeysDown[key_code(key)] = down;
#else
    ImGui::GetIO().AddKeyEvent(key_code(key), down);
#endif
}

inline void put_mouse_position(float x, float y) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().MousePos = {x, y};
#else
    ImGui::GetIO().AddMousePosEvent(x, y);
#endif
}

inline void put_mouse_button(int button, bool down) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().MouseDown[button] = down;
#else
    ImGui::GetIO().AddMouseButtonEvent(button, down);
#endif
}

class HeadlessUi {
 public:
    /// `draw` draws the panel; it is called once a frame.
    explicit HeadlessUi(std::function<void()> draw) : draw_(std::move(draw)) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {400, 900};
        prepare_input();
        io.UserData = &notes_;
        apply_theme({}, 1);
#if IMGUI_VERSION_NUM < 19200
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
#else
        io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#endif
        frame();
        frame();  // ImGui lays windows out over two frames
    }
    ~HeadlessUi() {
        ImGui::DestroyContext();
    }
    HeadlessUi(const HeadlessUi&) = delete;
    HeadlessUi& operator=(const HeadlessUi&) = delete;

    void frame(float seconds = 1.0f / 60) {
        ImGui::GetIO().DeltaTime = seconds;
        notes_.places.clear();
        new_frame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoNavInputs);
        draw_();
        ImGui::End();
        ImGui::Render();
    }

    /// Throws if no widget with that label was drawn.
    WidgetPlace place(const std::string& label) const {
        auto found = notes_.places.find(label);
        if (found == notes_.places.end()) throw std::runtime_error("no widget called " + label);
        return found->second;
    }
    bool has(const std::string& label) const {
        return notes_.places.contains(label);
    }
    const WidgetPlaces& places() const {
        return notes_.places;
    }

    void move_to(glm::vec2 p) {
        put_mouse_position(p.x, p.y);
        frame();
    }
    void press() {
        set_button(true);
    }
    void release() {
        set_button(false);
    }
    void click(const std::string& label) {
        move_to(at(label, 0.5f));
        press();
        release();
        settle();
    }
    void double_click(const std::string& label) {
        move_to(at(label, 0.5f));
        for (int i = 0; i < 2; ++i) {
            press();
            release();
        }
        settle();
    }
    /// Presses on a slider's track and lets go at another place; positions 0..1 along the track.
    void drag(const std::string& label, float from, float to) {
        move_to(at(label, from));
        press();
        move_to(at(label, (from + to) / 2));
        move_to(at(label, to));
        release();
        settle();
    }
    void type(const char* text) {
        ImGui::GetIO().AddInputCharactersUTF8(text);
        frame();
    }
    void key(Key key) {
        put_key(key, true);
        frame();
        put_key(key, false);
        frame();
    }
    /// Clicks a slider with Ctrl, which makes it take a text.
    void begin_typing(const std::string& label) {
        move_to(at(label, 0.3f));
        put_modifiers(GLFW_MOD_CONTROL);
        press();
        release();
        put_modifiers(0);
        frame();
        frame();
        if (!ImGui::GetIO().WantTextInput) throw std::runtime_error(label + " takes no text");
    }
    void enter(const std::string& label, const char* text) {
        begin_typing(label);
        type(text);
        key(Key::enter);
    }
    glm::vec2 at(const std::string& label, float along) const {
        WidgetPlace p = place(label);
        return {p.min.x + 1 + (p.max.x - p.min.x - 2) * along, (p.min.y + p.max.y) / 2};
    }

 private:
    // So that the next click is no double-click.
    void settle() {
        frame(1);
    }
    void set_button(bool down) {
        put_mouse_button(0, down);
        frame();
    }

    std::function<void()> draw_;
    WidgetNotes notes_;
};

}  // namespace dapple
