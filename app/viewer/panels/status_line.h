#pragma once
// The line of figures below the canvas.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/view/loupe_square.h"
#include "core/placing/page.h"
#include "core/text/length.h"

namespace dapple {

/// Someone who waits for longer wants to know for what, in seconds.
inline constexpr double kLongPlacing = 0.5;

struct StatusInfo {
    std::uint64_t dots = 0;        // of the whole page
    std::uint64_t duplicates = 0;  // among them
    double as_dense_as = 0;        // where a zoom brings more of them: so many on the page; 0: it does not
    bool figure8 = false;          // duplicates are worth a word
    double scale = 0;
    double tone_ms = 0, place_ms = 0, relax_ms = 0;
    int steps = 0, all_steps = 0;  // of relaxation: done, and to be done
    double draw_ms = 0;
    double placing_seconds = 0;               // that a placing under way has taken so far
    std::optional<double> placed_share = {};  // of its dots, 0..1, if that is known
    double frames_per_second = 0;
    std::string paper = {};            // "210 x 297 mm"
    double zoom = 1;                   // of the paper: 1 is as large as it is in the hand; 0: there is none
    bool method = false;               // whether its scale and its times are told too
    std::string plotting = {};         // how long a machine plots it: "plots about 31 min"; none: empty
    std::optional<LoupeInfo> loupe{};  // while it shows something
};

/// "40,000 dots", with how many there would be where a zoom brings more, and how many of them lie on another:
/// for Figure 8 only.
std::string dots_in_words(const StatusInfo& info);

/// "210 x 297 mm", "8.5 x 11 in".
std::string paper_in_words(const PageSize& page, LengthUnit unit);

/// What the line says, from the left to the right: dots and zoom first, and what only the method's section is
/// about where that is asked for. Where it is too narrow, the least important goes first.
struct StatusItem {
    std::string text;
    int importance = 0;
};
/// While a placing takes more than half a second it says how far it has come instead of how long the last one
/// took.
std::vector<StatusItem> status_items(const StatusInfo& info);

/// How far a placing of more than half a second, or what settles after it, has come, 0..1.
std::optional<double> progress_of(const StatusInfo& info);

/// Those that fit into a width, in their order; one at least.
std::vector<StatusItem> fitting(std::vector<StatusItem> items, float width);

/// A line over the whole width of a rectangle, with a bar at its upper edge while there is progress.
void draw_status_line(glm::vec2 corner, glm::vec2 size, const StatusInfo& info);

}  // namespace dapple
