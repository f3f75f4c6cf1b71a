#pragma once
// Dear ImGui's keyboard and mouse in one language for all of its releases: up to 1.86 keys are GLFW's codes
// and input is written into ImGuiIO; from 1.87 on keys have names and input goes in as events. Besides
// this header only window.cpp asks which release it is, where it hands GLFW's events on.

#include <imgui.h>

#include <cstdint>

#if IMGUI_VERSION_NUM < 18700
#include <GLFW/glfw3.h>
#endif

namespace dapple {

/// The keys that mean something here, by what is printed on them.
enum class Key {
    b,
    c,
    e,
    f,
    l,
    o,
    p,
    q,
    s,
    t,
    y,
    z,
    zero,
    tab,
    enter,
    keypad_enter,
    escape,
    backspace,
    end,
    f1,
    f11,
};

#if IMGUI_VERSION_NUM < 18700
using ImGuiKeyCode = int;
#else
using ImGuiKeyCode = ImGuiKey;
#endif

/// What IsKeyPressed() and IsKeyDown() take.
inline ImGuiKeyCode key_code(Key key) {
#if IMGUI_VERSION_NUM < 18700
#define DAPPLE_KEY(glfw, imgui) GLFW_KEY_##glfw
#else
#define DAPPLE_KEY(glfw, imgui) ImGuiKey_##imgui
#endif
    switch (key) {
        case Key::b:
            return DAPPLE_KEY(B, B);
        case Key::c:
            return DAPPLE_KEY(C, C);
        case Key::e:
            return DAPPLE_KEY(E, E);
        case Key::f:
            return DAPPLE_KEY(F, F);
        case Key::l:
            return DAPPLE_KEY(L, L);
        case Key::o:
            return DAPPLE_KEY(O, O);
        case Key::p:
            return DAPPLE_KEY(P, P);
        case Key::q:
            return DAPPLE_KEY(Q, Q);
        case Key::s:
            return DAPPLE_KEY(S, S);
        case Key::t:
            return DAPPLE_KEY(T, T);
        case Key::y:
            return DAPPLE_KEY(Y, Y);
        case Key::z:
            return DAPPLE_KEY(Z, Z);
        case Key::zero:
            return DAPPLE_KEY(0, 0);
        case Key::tab:
            return DAPPLE_KEY(TAB, Tab);
        case Key::enter:
            return DAPPLE_KEY(ENTER, Enter);
        case Key::keypad_enter:
            return DAPPLE_KEY(KP_ENTER, KeypadEnter);
        case Key::escape:
            return DAPPLE_KEY(ESCAPE, Escape);
        case Key::backspace:
            return DAPPLE_KEY(BACKSPACE, Backspace);
        case Key::end:
            return DAPPLE_KEY(END, End);
        case Key::f1:
            return DAPPLE_KEY(F1, F1);
        case Key::f11:
            return DAPPLE_KEY(F11, F11);
    }
#undef DAPPLE_KEY
    return {};
}

/// Went down since the last frame; a key that is held does so once.
inline bool key_pressed(Key key) {
    return ImGui::IsKeyPressed(key_code(key), false);
}
inline bool key_down(Key key) {
    return ImGui::IsKeyDown(key_code(key));
}

/// What ImGui calls an OpenGL texture: a pointer or a number.
inline ImTextureID texture_id(unsigned int gl_texture) {
    return (ImTextureID)(std::intptr_t)(gl_texture);  // whichever cast its type needs
}

// Input, as tests give it without a window. Between frames only.

/// Once for each context.
inline void prepare_input() {
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    io.KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
    io.KeyMap[ImGuiKey_Escape] = GLFW_KEY_ESCAPE;
    io.KeyMap[ImGuiKey_Backspace] = GLFW_KEY_BACKSPACE;
    io.KeyMap[ImGuiKey_End] = GLFW_KEY_END;
#else
    // A test says itself what lies in which frame.
    ImGui::GetIO().ConfigInputTrickleEventQueue = false;
#endif
}

inline void put_key(Key key, bool down) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeysDown[key_code(key)] = down;
#else
    ImGui::GetIO().AddKeyEvent(key_code(key), down);
#endif
}

inline void put_modifiers(bool ctrl, bool shift) {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM < 18700
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
    io.KeyMods = (ctrl ? ImGuiKeyModFlags_Ctrl : 0) | (shift ? ImGuiKeyModFlags_Shift : 0);
#elif IMGUI_VERSION_NUM < 18900
    io.AddKeyEvent(ImGuiKey_ModCtrl, ctrl);
    io.AddKeyEvent(ImGuiKey_ModShift, shift);
#else
    io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
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

}  // namespace dapple
