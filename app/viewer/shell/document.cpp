#include "app/viewer/shell/document.h"

#include <imgui.h>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/viewer/shell/window.h"

namespace dapple {

nlohmann::ordered_json status_json(const StatusInfo& info, std::uint64_t placings) {
    nlohmann::ordered_json line{{"dots", info.dots},       {"duplicates", info.duplicates},
                                {"scale", info.scale},     {"zoom", info.zoom},
                                {"placings", placings},    {"place_ms", info.place_ms},
                                {"draw_ms", info.draw_ms}, {"preview", info.preview},
                                {"steps", info.steps},     {"all_steps", info.all_steps}};
    if (const auto share = progress_of(info)) line["progress"] = *share;
    if (info.loupe)
        line["loupe"] = {{"repetition", info.loupe->repetition},
                         {"layers", info.loupe->layers},
                         {"level", info.loupe->level}};
    return line;
}

void StatusLog::took(double frame_ms, double work_ms) {
    if (!ready_ || frames_++ == 0) return;
    longest_frame_ms_ = std::max(longest_frame_ms_, frame_ms);
    longest_work_ms_ = std::max(longest_work_ms_, work_ms);
}

void StatusLog::write(std::optional<nlohmann::ordered_json> status, const WidgetNotes& widgets) {
    if (!status) return;
    if (!std::exchange(ready_, true)) std::puts("ready");
    if (all_) {
        gl_errors_ += Window::gl_errors();
        const ImGuiIO& io = ImGui::GetIO();
        nlohmann::ordered_json& line = *status;
        line["longest_frame_ms"] = longest_frame_ms_;
        line["longest_work_ms"] = longest_work_ms_;
        line["gl_errors"] = gl_errors_;
        line["mouse"] = {io.MousePos.x, io.MousePos.y};
        line["mouse_down"] = io.MouseDown[ImGuiMouseButton_Left];
        line["row_with_keys"] = widgets.row_with_keys;
        auto& places = line["widgets"] = nlohmann::ordered_json::object();
        for (const auto& [label, place] : widgets.places)
            places[label] = {place.min.x, place.min.y, place.max.x, place.max.y};
        std::string text = line.dump();
        if (text != written_) std::puts(text.c_str());
        written_ = std::move(text);
    }
    std::fflush(stdout);
}

}  // namespace dapple
