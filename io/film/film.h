#pragma once
// Films of a drawing: what is to be seen at each moment. The window plays them, `dapple record` writes them.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <ostream>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/image/grid.h"
#include "core/output/plotting_time.h"
#include "core/placing/dot_order.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/routing/short_way.h"
#include "core/strokes/strokes.h"
#include "core/text/names.h"
#include "core/watch.h"
#include "io/files/save_drawing.h"

namespace dapple {

// A drawing as a machine plots it: what is on the paper after so many seconds.

struct PlotFilm {
    DotPieces dots;               // in the machine's order;
    Strokes strokes;              // or, if there are any, these in their place
    std::vector<double> seconds;  // at which each dot, or each point of the strokes, is drawn; never falling
    double total_seconds = 0;

    /// How many dots, or points of strokes, there are after so long.
    std::size_t drawn_after(double seconds) const;
    /// In page units where these are dots, in millimetres where they are strokes. Nowhere before the first.
    std::optional<glm::dvec2> pen_at(std::size_t drawn) const;
};

/// The dots come in the order given, a touch each; its total is plotting_time()'s.
PlotFilm plot_film(DotPieces dots, double mm_per_page_unit, const MachineProgram& program);

/// Its total is figures_of()'s; along a stroke the pen goes at one speed.
PlotFilm plot_film(Strokes strokes, const MachineProgram& program);

/// The first so many, their pens and radii too.
DotPieces first_dots(const DotPieces& dots, std::size_t count);

/// The strokes of the first so many points.
Strokes first_points(const Strokes& strokes, std::size_t count);

enum class FilmKind {
    growth,  // the scale rises: from a few dots to all, none of which moves or goes before they settle
    levels,  // the subdivision: one level of tiles after the other, each in its colour
    zoom,    // towards the middle, where dots come in between as fast as the others part
    plot,    // stroke by stroke, as a machine draws it
};
constexpr auto names_of(FilmKind) {
    return names("growth", "levels", "zoom", "plot");
}

/// The shares of a film, 0..1, at which it has come to its end; the rest shows that.
inline constexpr double kFilmEnd = 0.9;

/// growth: how many of so many dots. As many times more in each second.
std::uint64_t grown_dots(double share, std::uint64_t dots);

/// growth: how often they have been relaxed, of so many times. They begin when all are there, and have
/// settled half-way through what is left.
int settling_steps(double share, int steps);

/// levels: the deepest that is shown, where `deepest` is the last one that has dots. Each takes as long.
int level_shown(double share, int deepest);

/// zoom: how many times larger, 1 to `depth`. As many times more in each second.
double film_zoom(double share, double depth);

/// plot: the seconds of the machine's that have passed, of so many.
double plotted_seconds(double share, double seconds);

struct FilmChoice {
    FilmKind kind = FilmKind::growth;
    double seconds = 8;          // kShortestFilm..kLongestFilm
    int frames_per_second = 25;  // 1..60
    int longer_side = 640;       // pixels, 16..4096
    double depth = 100;          // of the zoom, 1..kDeepestFilm times
    Machine machine = Machine::axidraw_v3;
    std::optional<DotOrder> order = {};  // of the plot; none: an SVG's usual one
};

inline constexpr double kShortestFilm = 0.1, kLongestFilm = 600, kDeepestFilm = 1e6;
/// In one film: more take longer for a frame than it lasts.
inline constexpr std::uint64_t kMostFilmDots = 2'000'000;

/// At least one.
int frames_of(const FilmChoice& choice);

// The pictures that a film is made of.

/// How a film changes what is drawn: growth, levels and zoom are the placer's own, so they show dots as
/// placed, round and in one ink, and at most kMostFilmDots of them; those of growth then settle, so that it
/// ends with the drawing. A plot is the drawing as it is saved.
DrawingSettings film_settings(DrawingSettings settings, FilmKind kind);

/// Draws a film's picture at a share of it, 0..1; all are as large.
using FilmFrame = std::function<Grid<glm::u8vec3>(double share)>;

/// A film of the drawing that those settings make. The pipeline needs its picture and tile, and has to
/// outlive the result. What is slow to find (a plotter's way) is found now; if stopped, the result is empty.
/// Throws as Pipeline::plan() does, and std::runtime_error if there is nothing to draw.
FilmFrame film_frames(Pipeline& pipeline, const DrawingSettings& settings, const FilmChoice& choice,
                      const Watch& watch = {});

// A film into a file.

// Moving pictures as an animated WebP, pixel for pixel.

class WebpFilm {
 public:
    /// It is played over and over.
    explicit WebpFilm(int frames_per_second);
    ~WebpFilm();

    /// sRGB-encoded; all as large, up to 16,383 pixels a side. Throws std::runtime_error if libwebp fails.
    void add(const Grid<glm::u8vec3>& frame);
    /// All of them. Needs one at least. Throws std::runtime_error if libwebp fails, and what the stream does.
    void write(std::ostream& out);

 private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

/// "Animation.webp" is one file, which web browsers play, over and over; "frames/", which ends in a slash or
/// is there, a folder of numbered PNG files for a program that makes films of them: frame-0001.png, ...
/// Throws std::runtime_error naming the path if it is neither, or cannot be written.
void check_film_path(const std::filesystem::path& path);

/// All that save_film() writes there.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& path, const FilmChoice& choice);

/// Returns false if stopped; then a film that was at that place is still there, while of a folder's frames
/// those that were written stay. Throws what check_film_path(), save_atomically() and the frames throw.
bool save_film(const std::filesystem::path& path, const FilmFrame& frame, const FilmChoice& choice,
               const Watch& watch = {});

}  // namespace dapple
