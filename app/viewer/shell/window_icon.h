#pragma once
// A window's icon.

struct GLFWwindow;

namespace dapple {

/// Gives the window the built-in icon in the sizes that desktops ask for.
void set_window_icon(GLFWwindow* window);

}  // namespace dapple
