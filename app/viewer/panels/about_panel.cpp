#include "app/viewer/panels/about_panel.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr float kWidth = 30;  // letters' heights

struct Library {
    const char* name;
    const char* licence;
    const char* version;
};

}  // namespace

bool draw_preferences_panel(bool& open, Appearance& appearance, bool& desktop_dialog) {
    const Dialog dialog("Preferences", open);
    if (!dialog) return false;
    ImGui::Dummy({kWidth * ImGui::GetTextLineHeight(), 0});
    int theme = static_cast<int>(appearance.theme);
    bool changed = segmented_row("Theme", theme, std::array{"light", "dark", "high contrast"},
                                 "How the window looks; the drawing and its files stay as they are.");
    appearance.theme = static_cast<Theme>(theme);
    int size = appearance.text_size < 0.95f  ? 0
               : appearance.text_size < 1.1f ? 1
               : appearance.text_size < 1.4f ? 2
                                             : 3;
    if (segmented_row("Text", size, std::array{"small", "usual", "large", "huge"},
                      "The size of all text and rows, beside the scale that the desktop asks for.", 1)) {
        appearance.text_size = std::array{0.85f, 1.0f, 1.25f, 1.6f}[static_cast<std::size_t>(size)];
        changed = true;
    }
    int whose = desktop_dialog ? 1 : 0;
    if (segmented_row(
            "Open with", whose, std::array{"own dialog", "desktop's"},
            "Which dialog asks for a file to open. The desktop's is shown by zenity or kdialog, where "
            "one of them is installed; exporting keeps Dapple's own, which has its options.")) {
        desktop_dialog = whose == 1;
        changed = true;
    }
    return changed;
}

void draw_about_panel(bool& open) {
    const Dialog dialog("About Dapple", open);
    if (!dialog) return;
    push_title_font();
    ImGui::TextUnformatted("Dapple " DAPPLE_VERSION);
    pop_title_font();
    ImGui::PushTextWrapPos(kWidth * ImGui::GetTextLineHeight());
    ImGui::TextUnformatted(
        "Photographs as dots, in real time. The method is Ares Lagae's and Philip Dutré's: a self-similar "
        "hierarchical tile, divided again and again (2006).");
    ImGui::TextUnformatted("Free to use, change and share under the MIT licence.");
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, ImGui::GetTextLineHeight() / 2});
    const std::string all = glfwGetVersionString(), glfw = all.substr(0, all.find(' '));
    const std::array kLibraries{
        Library{"Dear ImGui", "MIT", IMGUI_VERSION},
        Library{"GLFW", "zlib", glfw.c_str()},
        Library{"OpenImageIO", "BSD", "reads pictures, in a process of its own"},
        Library{"GLM, {fmt}, nlohmann-json, CLI11, libepoxy, stb", "MIT", ""},
        Library{"oneTBB, qpdf", "Apache 2.0", ""},
        Library{"Cairo", "LGPL or MPL", "draws PDF files"},
        Library{"libwebp, KISS FFT", "BSD", ""},
        Library{"libpng, libjpeg-turbo, libtiff, zlib, fontconfig", "their own, free", ""}};
    if (ImGui::BeginTable("libraries", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const Library& library : kLibraries) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(fmt::format("{} {}", library.name, library.version).c_str());
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", library.licence);
        }
        ImGui::EndTable();
    }
}

}  // namespace dapple
