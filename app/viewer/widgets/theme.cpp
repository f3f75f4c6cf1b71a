#include "app/viewer/widgets/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <system_error>

#include <fontconfig/fontconfig.h>
#include <imgui.h>

namespace dapple {
namespace {

constexpr float kTextHeight = 15;  // pixels at content scale 1

struct ThemeColours {
    glm::u8vec3 surround, panel, track, line, off, text, quiet, accent, warning;
};

constexpr ThemeColours kLight{{223, 219, 210}, {248, 246, 241}, {226, 221, 211},
                              {214, 208, 196}, {141, 135, 125}, {46, 44, 41},
                              {96, 91, 83},    {46, 84, 122},   {150, 52, 30}};
constexpr ThemeColours kDark{{24, 23, 22},    {36, 35, 33},    {62, 60, 57},
                             {72, 69, 65},    {128, 124, 117}, {236, 233, 226},
                             {188, 183, 174}, {134, 180, 224}, {244, 150, 122}};
constexpr ThemeColours kHighContrast{{64, 64, 64},    {0, 0, 0},       {56, 56, 56},
                                     {255, 255, 255}, {132, 132, 132}, {255, 255, 255},
                                     {226, 226, 226}, {255, 214, 0},   {255, 150, 120}};

const ThemeColours& palette_of(Theme theme) {
    return theme == Theme::light ? kLight : theme == Theme::dark ? kDark : kHighContrast;
}

// ImGui's style keeps the theme: each colour has a place there, some of them of things that nothing here
// draws.
ImGuiCol place_of(ThemeColour colour) {
    constexpr std::array kPlaces{ImGuiCol_NavWindowingDimBg, ImGuiCol_WindowBg,
                                 ImGuiCol_FrameBgActive,     ImGuiCol_Separator,
                                 ImGuiCol_PlotLines,         ImGuiCol_NavWindowingHighlight,
                                 ImGuiCol_TextDisabled,      ImGuiCol_CheckMark,
                                 ImGuiCol_PlotLinesHovered};  // as ThemeColour has them
    return kPlaces[static_cast<std::size_t>(colour)];
}

ImVec4 shade(glm::u8vec3 colour, float opacity = 1) {
    const glm::vec3 c = glm::vec3(colour) / 255.0f;
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

void set_colours(ImGuiStyle& style, Theme theme) {
    const auto& [surround, panel, track, line, off, text, quiet, accent, warning] = palette_of(theme);
    if (theme == Theme::light)
        ImGui::StyleColorsLight(&style);
    else
        ImGui::StyleColorsDark(&style);
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
    set(ImGuiCol_ModalWindowDimBg, shade(theme == Theme::light ? text : panel, 0.35f));
    set(place_of(ThemeColour::surround), shade(surround));
    set(place_of(ThemeColour::off), shade(off));
    set(place_of(ThemeColour::text), shade(text));
    set(place_of(ThemeColour::warning), shade(warning));
}

}  // namespace

glm::vec3 rgb_of(ThemeColour colour) {
    const ImVec4& c = ImGui::GetStyle().Colors[place_of(colour)];
    return {c.x, c.y, c.z};
}

std::uint32_t colour_of(ThemeColour colour) {
    return ImGui::GetColorU32(place_of(colour));  // paler where a row is greyed
}

std::uint32_t with_opacity(std::uint32_t colour, std::uint32_t opacity) {
    return (colour & ~IM_COL32_A_MASK) | opacity << IM_COL32_A_SHIFT;
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
    if (file && !is_outline_font(*file)) return std::nullopt;
    return file;
}

bool is_outline_font(const std::filesystem::path& file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) return false;
    std::ifstream in(file, std::ios::binary);
    const auto tag_at = [&](std::uint32_t at) {
        std::string tag(4, '\0');
        in.seekg(at).read(tag.data(), 4);
        return in ? tag : "";
    };
    const auto number_at = [&](std::uint32_t at) {
        std::uint32_t number = 0;
        for (const char byte : tag_at(at)) number = number << 8 | static_cast<unsigned char>(byte);
        return number;
    };
    const std::uint32_t font = tag_at(0) == "ttcf" ? number_at(12) : 0;  // a collection's first
    const std::string kind = tag_at(font);
    if (kind != std::string("\0\1\0\0", 4) && kind != "true" && kind != "OTTO") return false;
    bool letters = false, outlines = false;
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    const std::uint32_t tables = number_at(font + 4) >> 16;
    for (std::uint32_t entry = font + 12; entry < font + 12 + 16 * tables; entry += 16) {
        const std::string table = tag_at(entry);
        if (std::uintmax_t{number_at(entry + 8)} + number_at(entry + 12) > size) return false;
        letters |= table == "cmap";
        outlines |= table == "glyf" || table == "CFF ";
    }
    return letters && outlines;
}

void apply_theme(const Appearance& appearance, float content_scale) {
    content_scale *= std::clamp(appearance.text_size, kSmallestText, kLargestText);
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    float height = std::round(kTextHeight * content_scale);
    io.FontDefault = load_font("sans-serif", height);
    load_font("sans-serif:bold", height);

    ImGuiStyle style;
    set_colours(style, appearance.theme);
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
    // Where colours do not tell the panels from the canvas a line does.
    style.WindowBorderSize = appearance.theme == Theme::high_contrast ? 1 : 0;
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
