#include "app/viewer/panels/window_panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr std::array kKinds{"Growth", "Levels", "Zoom", "Plot"};  // as FilmKind has them
constexpr std::array kSeconds{2.0, 4.0, 8.0, 15.0, 30.0, 60.0, 300.0};
constexpr std::array kSecondsShown{"2 s", "4 s", "8 s", "15 s", "30 s", "1 min", "5 min"};

float button_width(const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool noted_button(const char* label) {
    const bool pressed = ImGui::Button(label);
    note_place(label);
    return pressed;
}

bool noted_combo(const char* label, int& chosen, std::span<const char* const> names, float width) {
    ImGui::SetNextItemWidth(width);
    const bool open =
        ImGui::BeginCombo((std::string("##") + label).c_str(), names[static_cast<std::size_t>(chosen)]);
    note_place(label);
    if (!open) return false;
    const int before = chosen;
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        const char* const name = names[static_cast<std::size_t>(i)];
        if (ImGui::Selectable(name, i == before)) chosen = i;
        note_place((std::string(label) + " " + name).c_str());
    }
    ImGui::EndCombo();
    return chosen != before;
}

}  // namespace

float player_bar_height() {
    return ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y;
}

PlayerWish draw_player_bar(PlayedFilm& film, const std::string& words, FilmKind& chosen, glm::vec2 corner,
                           glm::vec2 size) {
    PlayerWish wish = PlayerWish::none;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    begin_bare("##player", {corner.x, corner.y}, {size.x, player_bar_height()},
               ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoScrollWithMouse);
    // Where there is no room for all, what is needed least goes.
    const float line = ImGui::GetTextLineHeight(), air = ImGui::GetStyle().ItemSpacing.x;
    const float kind_width = 6.5f * line, words_width = 11 * line, seconds_width = 5.5f * line;
    float room = ImGui::GetContentRegionAvail().x - button_width("Pause") - button_width("Close") - air;
    const auto fits = [&](float width) {
        const bool there = room >= width + air;
        if (there) room -= width + air;
        return there;
    };
    const bool has_moment = fits(3 * line), has_kind = fits(kind_width),
               has_save = fits(button_width("Save film...")), has_words = fits(words_width),
               has_seconds = fits(seconds_width);
    if (has_kind) {
        int kind = static_cast<int>(film.kind);
        if (noted_combo("Film", kind, kKinds, kind_width)) {
            chosen = static_cast<FilmKind>(kind);
            wish = PlayerWish::other_film;
        }
        tip_above(
            "growth: from a few dots to all, which then relax.\n"
            "levels: one level of tiles after another.\n"
            "zoom: into the middle, with ever more dots.\n"
            "plot: stroke by stroke, as a machine draws it.");
        ImGui::SameLine();
    }
    const bool pressed =
        ImGui::Button(film.running ? "Pause##play" : "Play##play", {button_width("Pause"), 0});
    note_place("Play film");
    tip_above(with_keys("Play or pause.", Action::play).c_str());
    if (pressed && film.running)
        film.running = false;
    else if (pressed)
        run_on(film);
    ImGui::SameLine();
    if (has_moment) {
        ImGui::SetNextItemWidth(3 * line + std::max(room, 0.0f));
        auto share = static_cast<float>(film.share);
        if (ImGui::SliderFloat("##moment", &share, 0, 1, "")) {
            film.share = std::clamp<double>(share, 0, 1);
            film.running = false;
        }
        note_place("Moment");
        tip_above("Position in the film.");
        ImGui::SameLine();
    }
    if (has_words) {
        const float words_begin = ImGui::GetCursorPosX();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(words.c_str());
        ImGui::SameLine(words_begin + words_width + air);
    }
    if (has_seconds) {
        const auto known = std::ranges::find(kSeconds, film.seconds);
        int takes = known == kSeconds.end() ? 2 : static_cast<int>(known - kSeconds.begin());
        if (noted_combo("Takes", takes, kSecondsShown, seconds_width))
            film.seconds = kSeconds[static_cast<std::size_t>(takes)];
        tip_above("Length of the film.");
        ImGui::SameLine();
    }
    if (has_save) {
        if (noted_button("Save film...")) wish = PlayerWish::save;
        tip_above("Saves an animated WebP, which web browsers play.");
        ImGui::SameLine();
    }
    if (noted_button("Close")) wish = PlayerWish::close;
    tip_above("Back to the drawing.   Escape");
    ImGui::End();
    ImGui::PopStyleVar();
    return wish;
}

}  // namespace dapple
