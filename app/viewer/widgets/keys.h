#pragma once
// Dear ImGui's keyboard and mouse in one language for all of its releases: up to 1.86 keys are GLFW's codes
// and input is written into ImGuiIO; from 1.87 on keys have names and input goes in as events. Besides
// this header only window.cpp, where it hands GLFW's events on, and tests ask which release it is.

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cstdint>

namespace dapple {

#if IMGUI_VERSION_NUM < 18700
using ImGuiKeyCode = int;
#define DAPPLE_KEY(glfw, imgui) GLFW_KEY_##glfw
#else
using ImGuiKeyCode = ImGuiKey;
#define DAPPLE_KEY(glfw, imgui) ImGuiKey_##imgui
#endif

/// The keys that mean something here, by what is printed on them.
enum class Key : int {
    b = DAPPLE_KEY(B, B),
    c = DAPPLE_KEY(C, C),
    d = DAPPLE_KEY(D, D),
    e = DAPPLE_KEY(E, E),
    f = DAPPLE_KEY(F, F),
    i = DAPPLE_KEY(I, I),
    k = DAPPLE_KEY(K, K),
    l = DAPPLE_KEY(L, L),
    m = DAPPLE_KEY(M, M),
    o = DAPPLE_KEY(O, O),
    p = DAPPLE_KEY(P, P),
    q = DAPPLE_KEY(Q, Q),
    r = DAPPLE_KEY(R, R),
    s = DAPPLE_KEY(S, S),
    t = DAPPLE_KEY(T, T),
    v = DAPPLE_KEY(V, V),
    w = DAPPLE_KEY(W, W),
    x = DAPPLE_KEY(X, X),
    y = DAPPLE_KEY(Y, Y),
    z = DAPPLE_KEY(Z, Z),
    zero = DAPPLE_KEY(0, 0),
    comma = DAPPLE_KEY(COMMA, Comma),
    backslash = DAPPLE_KEY(BACKSLASH, Backslash),
    up = DAPPLE_KEY(UP, UpArrow),
    down = DAPPLE_KEY(DOWN, DownArrow),
    left = DAPPLE_KEY(LEFT, LeftArrow),
    right = DAPPLE_KEY(RIGHT, RightArrow),
    space = DAPPLE_KEY(SPACE, Space),
    tab = DAPPLE_KEY(TAB, Tab),
    enter = DAPPLE_KEY(ENTER, Enter),
    keypad_enter = DAPPLE_KEY(KP_ENTER, KeypadEnter),
    escape = DAPPLE_KEY(ESCAPE, Escape),
    backspace = DAPPLE_KEY(BACKSPACE, Backspace),
    end = DAPPLE_KEY(END, End),
    f1 = DAPPLE_KEY(F1, F1),
    f11 = DAPPLE_KEY(F11, F11),
};
#undef DAPPLE_KEY

/// What IsKeyPressed() and IsKeyDown() take.
inline ImGuiKeyCode key_code(Key key) {
    return static_cast<ImGuiKeyCode>(key);
}

/// Went down since the last frame; a key that is held does so once.
inline bool key_pressed(Key key) {
    return ImGui::IsKeyPressed(key_code(key), false);
}
inline bool key_down(Key key) {
    return ImGui::IsKeyDown(key_code(key));
}
inline bool enter_pressed() {
    return key_pressed(Key::enter) || key_pressed(Key::keypad_enter);
}

/// Which way two keys ask to go, 1, -1 or 0: they went down since the last frame, or repeat while they are
/// held.
inline int step_between(Key back, Key forward) {
    return ImGui::IsKeyPressed(key_code(forward), true) - ImGui::IsKeyPressed(key_code(back), true);
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

// Input, between frames.

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

}  // namespace dapple
