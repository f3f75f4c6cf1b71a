#include "app/viewer/panels/settings_panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr float kHeight = 64, kFoot = 11, kHandle = 5.5f;  // in fifteenths of a text line: pixels at 96 dpi
constexpr int kColumns = 128;                              // two 8-bit values each, so that none is empty
constexpr float kGap = 0.01f;                              // black stays below white
constexpr float kLeastGamma = 0.25f, kMostGamma = 4;

enum Handle { kBlackHandle, kMiddleHandle, kWhiteHandle };
constexpr std::array<const char*, 3> kNames{"Black point handle", "Middle handle", "White point handle"};

struct Frame {
    ImVec2 min, max;  // of the bars; the handles are below
    float unit;

    float x_of(float encoded) const { return min.x + (max.x - min.x) * encoded; }
    float encoded_at(float x) const { return (x - min.x) / std::max(1.0f, max.x - min.x); }
};

// The encoded value that ink covers half of the paper for: half of white's light.
float half_covered() {
    return linear_to_srgb(0.5f);
}

std::array<float, 3> handle_values(const Tone& tone) {
    return {tone.black_point, middle_of(tone), tone.white_point};
}

// The first of those that are nearest, unless the pointer is to its right: handles in one place can be
// parted.
int nearest_handle(const std::array<float, 3>& values, float encoded) {
    int nearest = 0;
    for (int i = 1; i < 3; ++i) {
        const float distance = std::abs(values[i] - encoded), least = std::abs(values[nearest] - encoded);
        if (distance < least || (distance == least && encoded > values[i])) nearest = i;
    }
    return nearest;
}

void move_handle(int handle, float encoded, Tone& tone) {
    if (handle == kBlackHandle)
        tone.black_point = std::clamp(encoded, 0.0f, std::max(0.0f, tone.white_point - kGap));
    if (handle == kWhiteHandle)
        tone.white_point = std::clamp(encoded, std::min(1.0f, tone.black_point + kGap), 1.0f);
    if (handle == kMiddleHandle) {
        const float range = std::max(tone.white_point - tone.black_point, kGap);
        const float at = std::clamp((encoded - tone.black_point) / range, 1e-4f, 0.9999f);
        tone.gamma = std::clamp(std::log(at) / std::log(half_covered()), kLeastGamma, kMostGamma);
    }
}

// Heights of the columns, 0..1, the highest but for a few of them (a white ground, say) 1.
std::array<float, kColumns> column_heights(const Histogram& histogram) {
    std::array<float, kColumns> heights{};
    for (int i = 0; i <= Histogram::kSteps; ++i)
        heights[i * kColumns / (Histogram::kSteps + 1)] += static_cast<float>(histogram.counts[i]);
    std::array<float, kColumns> sorted = heights;
    std::ranges::sort(sorted);
    float full = sorted[kColumns - 4];
    if (full <= 0) full = sorted.back();
    if (full <= 0) return {};
    for (float& height : heights) height = std::min(1.0f, std::sqrt(height / full));
    return heights;
}

void draw_bars(const Frame& frame, const Histogram& histogram, const Tone& tone) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(frame.min, frame.max, colour_of(ThemeColour::track), 3 * frame.unit);
    const std::array<float, kColumns> heights = column_heights(histogram);
    const float room = frame.max.y - frame.min.y - 3 * frame.unit;
    const std::uint32_t quiet = colour_of(ThemeColour::quiet);
    for (int i = 0; i < kColumns; ++i) {
        if (heights[i] <= 0) continue;
        const float middle = (static_cast<float>(i) + 0.5f) / kColumns;
        const bool clipped = middle < tone.black_point || middle > tone.white_point;
        // Whole pixels, so that no gaps shimmer between the columns.
        const float left = std::floor(frame.x_of(static_cast<float>(i) / kColumns));
        const float right = std::floor(frame.x_of(static_cast<float>(i + 1) / kColumns));
        list->AddRectFilled({left, frame.max.y - room * heights[i]}, {right, frame.max.y},
                            clipped ? with_opacity(quiet, 90) : quiet);
    }
}

void draw_handle(const Frame& frame, float encoded, bool hot, ThemeColour fill) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float x = frame.x_of(encoded), y = frame.max.y, size = kHandle * frame.unit * (hot ? 1.15f : 1);
    const auto accent = colour_of(ThemeColour::accent);
    list->AddLine({x, frame.min.y}, {x, y}, accent, frame.unit * (hot ? 1.5f : 1));
    const ImVec2 tip{x, y + frame.unit}, left{x - size, y + 1.7f * size}, right{x + size, y + 1.7f * size};
    list->AddTriangleFilled(tip, right, left, colour_of(fill));
    list->AddTriangle(tip, right, left, accent, 1.2f * frame.unit);
}

// Where a test can press: the part of the column about the handle that is below the bars.
void note_handle(const Frame& frame, int handle, float encoded) {
    const float x = frame.x_of(encoded), half = kHandle * frame.unit;
    ImGui::SetCursorScreenPos({x - half, frame.max.y});
    ImGui::Dummy({2 * half, kFoot * frame.unit});
    note_place(kNames[handle]);
}

}  // namespace

float middle_of(const Tone& tone) {
    return tone.black_point + (tone.white_point - tone.black_point) * std::pow(half_covered(), tone.gamma);
}

bool draw_histogram(const Histogram& histogram, Tone& tone) {
    const float unit = ImGui::GetTextLineHeight() / 15;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = std::max(20 * unit, ImGui::GetContentRegionAvail().x);
    const float margin = kHandle * unit;  // so that handles at the ends are whole
    const Frame frame{
        {start.x + margin, start.y}, {start.x + width - margin, start.y + kHeight * unit}, unit};

    ImGui::PushID("histogram");
    press_area("handles", {width, (kHeight + kFoot) * unit});
    note_place("Histogram");
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    const float mouse = ImGui::GetIO().MousePos.x;
    const Tone before = tone;
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID taken = ImGui::GetID("taken"), grip = ImGui::GetID("grip"), moved = ImGui::GetID("moved");
    if (ImGui::IsItemActivated()) {
        const std::array<float, 3> values = handle_values(tone);
        const int nearest = nearest_handle(values, frame.encoded_at(mouse));
        const float offset = mouse - frame.x_of(values[nearest]);
        // A handle that is pressed stays under the pointer as it was, and still until that moves; a press
        // beside it brings it there.
        const bool pressed = std::abs(offset) <= margin;
        storage->SetInt(taken, nearest);
        storage->SetFloat(grip, pressed ? offset : 0);
        storage->SetBool(moved, !pressed);
    }
    if (active && mouse != ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left].x)
        storage->SetBool(moved, true);
    if (active && storage->GetBool(moved))
        move_handle(storage->GetInt(taken), frame.encoded_at(mouse - storage->GetFloat(grip)), tone);

    draw_bars(frame, histogram, tone);
    const std::array<float, 3> drawn = handle_values(tone);
    const int hot = active    ? storage->GetInt(taken)
                    : hovered ? nearest_handle(drawn, frame.encoded_at(mouse))
                              : -1;
    constexpr std::array kFills{ThemeColour::text, ThemeColour::quiet, ThemeColour::panel};
    for (int i = 0; i < 3; ++i) {
        draw_handle(frame, drawn[i], i == hot, kFills[i]);
        note_handle(frame, i, drawn[i]);
        tip("Black point, middle and white point: drag, or use the arrows.");
        if (const RowKeys keys = item_keys(kNames[i]); keys.step != 0)
            move_handle(i, drawn[i] + 0.01f * static_cast<float>(keys.step), tone);
    }
    ImGui::PopID();
    go_on_at({start.x, start.y + (kHeight + kFoot) * unit + ImGui::GetStyle().ItemSpacing.y});
    return tone != before;
}

}  // namespace dapple
