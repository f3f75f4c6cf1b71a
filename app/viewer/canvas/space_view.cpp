#include "app/viewer/canvas/space_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <utility>

#include "app/viewer/background/with_alpha.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

constexpr float kLargestSide = 480, kLeastSide = 48;  // at 96 dpi
constexpr int kMostPixels = 600;                      // a side: what is drawn within 10 ms
constexpr double kFrame = 1.0 / 30, kATurn = 24;      // seconds
constexpr double kLongestFrame = 0.1;                 // seconds: after a rest it does not jump
constexpr double kSteepest = 1.4;                     // radians

}  // namespace

void SpaceView::hide() {
    placing_.stop();
    asked_.reset();
    seen_ = false;
    next_frame_.reset();
}

void SpaceView::update(const SpaceChoice& choice) {
    try {
        while (std::optional<SpaceDots> dots = placing_.result()) {
            dots_ = std::move(*dots);
            boundaries_.reset();
        }
    } catch (const std::exception& error) {
        trouble_ = error.what();
    }
    if (asked_ == choice) return;
    placing_.stop();
    if (placing_.busy()) return;  // its end wakes the window
    trouble_.clear();
    placing_.begin(space_work(choice));
    asked_ = choice;
}

// The side that is in front goes with the mouse.
void SpaceView::turn(SpaceSettings& settings, double pixels) const {
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = ImGui::IsItemActive();
    if (held) {
        const double radians = 3 / std::max(pixels, 1.0);
        settings.turn += radians * io.MouseDelta.x / (2 * std::numbers::pi);
        settings.down = std::clamp(settings.down + radians * io.MouseDelta.y, -kSteepest, kSteepest);
    } else if (settings.turning) {
        settings.turn += std::min<double>(io.DeltaTime, kLongestFrame) / kATurn;
    }
    settings.turn -= std::floor(settings.turn);
}

void SpaceView::draw_picture(const TurnedView& view, bool boundaries) {
    if (boundaries_ != boundaries) {
        balls_ = balls_of(dots_, boundaries);
        boundaries_ = boundaries;
        drawn_.reset();
    }
    if (drawn_ == view) return;
    picture_.write(with_alpha(turned_view(balls_, view)));
    drawn_ = view;
}

std::string SpaceView::words() const {
    if (!trouble_.empty()) return trouble_;
    if (dots_.places.empty()) return "Placing dots...";
    const std::string count = grouped(dots_.places.size()) + " dots, ";
    if (dots_.all_steps == 0) return count + "as placed";
    if (dots_.steps < dots_.all_steps)
        return count + fmt::format("settling: {} of {} steps", dots_.steps, dots_.all_steps);
    return count + fmt::format("settled in {} steps", dots_.steps);
}

void SpaceView::draw(SpaceSettings& settings, bool boundaries, const CanvasPlace& place,
                     double last_seconds) {
    const float unit = ImGui::GetFontSize() / 15, air = 12 * unit, line = ImGui::GetTextLineHeight();
    const float side =
        std::floor(std::min({kLargestSide * unit, place.size.x - 4 * air, place.size.y - 4.5f * air - line}));
    if (side < kLeastSide * unit) return hide();
    update(settings.choice);
    seen_ = true;
    next_frame_.reset();  // on a slow machine the dots, too, are to get on
    if (settings.turning) next_frame_ = std::max(kFrame, last_seconds);
    const ImVec2 card{side + 2 * air, side + line + 2.5f * air};
    const ImVec2 at{std::floor(place.corner.x + place.size.x - air - card.x),
                    std::floor(place.corner.y + place.size.y - air - card.y)};
    draw_shadow(ImGui::GetBackgroundDrawList(), at, {at.x + card.x, at.y + card.y});
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {air, air});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8 * unit);
    ImGui::Begin("##space", nullptr,
                 kNeverAsksForFocus | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
    press_area("picture", {side, side});
    note_place("Dots in space");
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const double pixels = side * place.pixels_per_point.x;
    turn(settings, side);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, IM_COL32_WHITE, 4 * unit);
    if (!dots_.places.empty()) {
        draw_picture({.box = space_box(),
                      .turn = settings.turn,
                      .down = settings.down,
                      .side = std::min(static_cast<int>(std::lround(pixels)), kMostPixels)},
                     boundaries);
        list->AddImageRounded(texture_id(picture_.get()), low, high, {0, 0}, {1, 1}, IM_COL32_WHITE,
                              4 * unit);
    }
    list->AddText({low.x, high.y + 0.5f * air}, colour_of(ThemeColour::quiet), words().c_str());
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace dapple
