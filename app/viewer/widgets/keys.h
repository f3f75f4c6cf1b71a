#pragma once
// Dear ImGui's keyboard and mouse in one language for all of its releases: up to 1.86 keys are GLFW's codes
// and input is written into ImGuiIO; from 1.87 on keys have names and input goes in as events. Besides
// this header only window.cpp asks which release it is, where it hands GLFW's events on.

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cstdint>

namespace dapple {

/// The keys that mean something here, by what is printed on them.
enum class Key {
    b,
    c,
    d,
    e,
    f,
    i,
    l,
    m,
    o,
    p,
    q,
    r,
    s,
    t,
    v,
    w,
    x,
    y,
    z,
    zero,
    comma,
    backslash,
    up,
    down,
    left,
    right,
    space,
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
        case Key::d:
            return DAPPLE_KEY(D, D);
        case Key::e:
            return DAPPLE_KEY(E, E);
        case Key::f:
            return DAPPLE_KEY(F, F);
        case Key::i:
            return DAPPLE_KEY(I, I);
        case Key::l:
            return DAPPLE_KEY(L, L);
        case Key::m:
            return DAPPLE_KEY(M, M);
        case Key::o:
            return DAPPLE_KEY(O, O);
        case Key::p:
            return DAPPLE_KEY(P, P);
        case Key::q:
            return DAPPLE_KEY(Q, Q);
        case Key::r:
            return DAPPLE_KEY(R, R);
        case Key::s:
            return DAPPLE_KEY(S, S);
        case Key::t:
            return DAPPLE_KEY(T, T);
        case Key::v:
            return DAPPLE_KEY(V, V);
        case Key::w:
            return DAPPLE_KEY(W, W);
        case Key::x:
            return DAPPLE_KEY(X, X);
        case Key::y:
            return DAPPLE_KEY(Y, Y);
        case Key::z:
            return DAPPLE_KEY(Z, Z);
        case Key::zero:
            return DAPPLE_KEY(0, 0);
        case Key::comma:
            return DAPPLE_KEY(COMMA, Comma);
        case Key::backslash:
            return DAPPLE_KEY(BACKSLASH, Backslash);
        case Key::up:
            return DAPPLE_KEY(UP, UpArrow);
        case Key::down:
            return DAPPLE_KEY(DOWN, DownArrow);
        case Key::left:
            return DAPPLE_KEY(LEFT, LeftArrow);
        case Key::right:
            return DAPPLE_KEY(RIGHT, RightArrow);
        case Key::space:
            return DAPPLE_KEY(SPACE, Space);
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

/// Keys are not the window's until the next frame is over: io.WantCaptureKeyboard will say so.
inline void take_keyboard() {
#if IMGUI_VERSION_NUM < 18900
    ImGui::CaptureKeyboardFromApp(true);
#else
    ImGui::SetNextFrameWantCaptureKeyboard(true);
#endif
}

/// What ImGui calls an OpenGL texture: a pointer or a number.
inline ImTextureID texture_id(unsigned int gl_texture) {
    return (ImTextureID)(std::intptr_t)(gl_texture);  // whichever cast its type needs
}

// Input, between frames. Tests give it with these without a window.

/// Once for each context.
inline void prepare_input() {
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    io.KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
    io.KeyMap[ImGuiKey_Escape] = GLFW_KEY_ESCAPE;
    io.KeyMap[ImGuiKey_Backspace] = GLFW_KEY_BACKSPACE;
    io.KeyMap[ImGuiKey_End] = GLFW_KEY_END;
    io.KeyMap[ImGuiKey_Z] = GLFW_KEY_Z;
#else
    // What lies in which frame is decided here: by input_queue.h, and by tests.
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

/// All that are down, as GLFW's bits.
inline void put_modifiers(int modifiers) {
    ImGuiIO& io = ImGui::GetIO();
    const bool ctrl = modifiers & GLFW_MOD_CONTROL, shift = modifiers & GLFW_MOD_SHIFT,
               alt = modifiers & GLFW_MOD_ALT, super = modifiers & GLFW_MOD_SUPER;
#if IMGUI_VERSION_NUM < 18700
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
    io.KeyAlt = alt;
    io.KeySuper = super;
    io.KeyMods = (ctrl ? ImGuiKeyModFlags_Ctrl : 0) | (shift ? ImGuiKeyModFlags_Shift : 0) |
                 (alt ? ImGuiKeyModFlags_Alt : 0) | (super ? ImGuiKeyModFlags_Super : 0);
#else
#if IMGUI_VERSION_NUM < 18900
    constexpr auto kCtrl = ImGuiKey_ModCtrl, kShift = ImGuiKey_ModShift, kAlt = ImGuiKey_ModAlt,
                   kSuper = ImGuiKey_ModSuper;
#else
    constexpr auto kCtrl = ImGuiMod_Ctrl, kShift = ImGuiMod_Shift, kAlt = ImGuiMod_Alt,
                   kSuper = ImGuiMod_Super;
#endif
    io.AddKeyEvent(kCtrl, ctrl);
    io.AddKeyEvent(kShift, shift);
    io.AddKeyEvent(kAlt, alt);
    io.AddKeyEvent(kSuper, super);
#endif
}

#if IMGUI_VERSION_NUM >= 18700
/// ImGui's name of a key of GLFW's; None for those that it edits, walks and copies without and that mean
/// nothing here.
inline ImGuiKey imgui_key(int glfw_key) {
    const auto along = [&](ImGuiKey first, int glfw_first) {
        return static_cast<ImGuiKey>(first + (glfw_key - glfw_first));
    };
    if (glfw_key >= GLFW_KEY_A && glfw_key <= GLFW_KEY_Z) return along(ImGuiKey_A, GLFW_KEY_A);
    if (glfw_key >= GLFW_KEY_0 && glfw_key <= GLFW_KEY_9) return along(ImGuiKey_0, GLFW_KEY_0);
    if (glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_9) return along(ImGuiKey_Keypad0, GLFW_KEY_KP_0);
    if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F12) return along(ImGuiKey_F1, GLFW_KEY_F1);
    constexpr struct {
        int glfw;
        ImGuiKey imgui;
    } kOthers[] = {
        {GLFW_KEY_COMMA, ImGuiKey_Comma},
        {GLFW_KEY_BACKSLASH, ImGuiKey_Backslash},
        {GLFW_KEY_TAB, ImGuiKey_Tab},
        {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
        {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
        {GLFW_KEY_UP, ImGuiKey_UpArrow},
        {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
        {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
        {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
        {GLFW_KEY_HOME, ImGuiKey_Home},
        {GLFW_KEY_END, ImGuiKey_End},
        {GLFW_KEY_INSERT, ImGuiKey_Insert},
        {GLFW_KEY_DELETE, ImGuiKey_Delete},
        {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
        {GLFW_KEY_SPACE, ImGuiKey_Space},
        {GLFW_KEY_ENTER, ImGuiKey_Enter},
        {GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter},
        {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
    };
    for (const auto& key : kOthers) {
        if (key.glfw == glfw_key) return key.imgui;
    }
    return ImGuiKey_None;
}
#endif

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
