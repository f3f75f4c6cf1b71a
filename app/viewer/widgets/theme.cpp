#include "app/viewer/widgets/theme.h"

#include <cmath>
#include <string>

#include <fontconfig/fontconfig.h>
#include <imgui.h>

namespace dapple {
namespace {

constexpr float kTextHeight = 15;  // pixels at content scale 1

glm::u8vec3 bytes_of(ThemeColour colour) {
    switch (colour) {
        case ThemeColour::surround:
            return {223, 219, 210};
        case ThemeColour::panel:
            return {248, 246, 241};
        case ThemeColour::track:
            return {226, 221, 211};
        case ThemeColour::line:
            return {214, 208, 196};
        case ThemeColour::text:
            return {46, 44, 41};
        case ThemeColour::quiet:
            return {117, 111, 101};
        case ThemeColour::accent:
            return {46, 84, 122};
        case ThemeColour::warning:
            return {160, 60, 36};
    }
    return {};
}

ImVec4 shade(ThemeColour colour, float opacity = 1) {
    glm::vec3 c = rgb_of(colour);
    return {c.r, c.g, c.b, opacity};
}

ImFont* load_font(const char* pattern, float height) {
    ImGuiIO& io = ImGui::GetIO();
    // Latin, and the few signs that the panels use: dashes, quotes, the ellipsis, arrows.
    static const ImWchar kLetters[] = {0x20, 0x17f, 0x2010, 0x2026, 0x2190, 0x2193, 0};
    if (auto file = find_font(pattern))
        if (ImFont* font = io.Fonts->AddFontFromFileTTF(file->c_str(), height, nullptr, kLetters))
            return font;
    ImFontConfig config;
    config.SizePixels = height;
    return io.Fonts->AddFontDefault(&config);
}

void set_colours(ImGuiStyle& style) {
    using enum ThemeColour;
    ImGui::StyleColorsLight(&style);
    auto set = [&](ImGuiCol where, ImVec4 colour) { style.Colors[where] = colour; };
    set(ImGuiCol_Text, shade(text));
    set(ImGuiCol_TextDisabled, shade(quiet));
    set(ImGuiCol_WindowBg, shade(panel));
    set(ImGuiCol_ChildBg, shade(panel, 0));
    set(ImGuiCol_PopupBg, shade(panel));
    set(ImGuiCol_Border, shade(line));
    set(ImGuiCol_FrameBg, shade(track, 0.75f));
    set(ImGuiCol_FrameBgHovered, shade(track));
    set(ImGuiCol_FrameBgActive, shade(track));
    set(ImGuiCol_Header, shade(accent, 0.14f));
    set(ImGuiCol_HeaderHovered, shade(accent, 0.10f));
    set(ImGuiCol_HeaderActive, shade(accent, 0.20f));
    set(ImGuiCol_Button, shade(track, 0.9f));
    set(ImGuiCol_ButtonHovered, shade(accent, 0.22f));
    set(ImGuiCol_ButtonActive, shade(accent, 0.34f));
    set(ImGuiCol_CheckMark, shade(accent));
    set(ImGuiCol_SliderGrab, shade(accent));
    set(ImGuiCol_SliderGrabActive, shade(accent));
    set(ImGuiCol_PlotHistogram, shade(accent));
    set(ImGuiCol_TextSelectedBg, shade(accent, 0.25f));
    set(ImGuiCol_ScrollbarBg, shade(panel, 0));
    set(ImGuiCol_ScrollbarGrab, shade(line));
    set(ImGuiCol_ScrollbarGrabHovered, shade(quiet, 0.6f));
    set(ImGuiCol_ScrollbarGrabActive, shade(quiet));
    set(ImGuiCol_Separator, shade(line));
    set(ImGuiCol_TitleBg, shade(panel));
    set(ImGuiCol_TitleBgActive, shade(panel));
    set(ImGuiCol_ModalWindowDimBg, shade(text, 0.35f));
}

}  // namespace

glm::vec3 rgb_of(ThemeColour colour) {
    return glm::vec3(bytes_of(colour)) / 255.0f;
}

std::uint32_t colour_of(ThemeColour colour) {
    auto c = bytes_of(colour);
    return ImGui::GetColorU32(IM_COL32(c.r, c.g, c.b, 255));  // paler where a row is greyed
}

std::optional<std::filesystem::path> find_font(const char* pattern) {
    FcPattern* wanted = FcNameParse(reinterpret_cast<const FcChar8*>(pattern));
    if (!wanted) return std::nullopt;
    FcConfigSubstitute(nullptr, wanted, FcMatchPattern);
    FcDefaultSubstitute(wanted);
    FcResult result{};
    FcPattern* found = FcFontMatch(nullptr, wanted, &result);
    std::optional<std::filesystem::path> file;
    FcChar8* name = nullptr;
    if (found && FcPatternGetString(found, FC_FILE, 0, &name) == FcResultMatch)
        file = reinterpret_cast<const char*>(name);
    if (found) FcPatternDestroy(found);
    FcPatternDestroy(wanted);
    FcFini();
    if (file && !std::filesystem::is_regular_file(*file)) return std::nullopt;
    return file;
}

void apply_theme(float content_scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    float height = std::round(kTextHeight * content_scale);
    io.FontDefault = load_font("sans-serif", height);
    load_font("sans-serif:bold", height);

    ImGuiStyle style;
    set_colours(style);
    style.WindowPadding = {16, 12};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 5};
    style.ItemInnerSpacing = {6, 4};
    style.FrameRounding = 6;
    style.GrabRounding = 6;
    style.PopupRounding = 8;
    style.WindowRounding = 8;
    style.ScrollbarRounding = 6;
    style.ScrollbarSize = 10;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.WindowTitleAlign = {0, 0.5f};
    style.ScaleAllSizes(content_scale);
    ImGui::GetStyle() = style;
}

void push_title_font() {
    const auto& fonts = ImGui::GetIO().Fonts->Fonts;
    ImGui::PushFont(fonts.Size > 1 ? fonts[1] : fonts[0]);
}

void pop_title_font() {
    ImGui::PopFont();
}

}  // namespace dapple
