// How good pictures are, beside a peer's: Dapple's dots as placed and after some steps of relaxation, and
// plain weighted Voronoi stippling (Secord 2002) from random dots. Prints tables in Markdown.
//
//      picture_quality PHOTO...                    at 5,000, 20,000 and 100,000 dots; and seams on black
//      picture_quality                             the same of the built-in still life
//      picture_quality --dots 40000 --steps 0,3 --peer-steps 50 PHOTO...
//      picture_quality --only seams --loads 1.35   or --only pictures, or black
//      picture_quality --only edges --dots 40000 --steps 0,3,5,20 PHOTO...     not without being asked for
//      picture_quality --side-by-side FILE.png     the first photograph and its drawings, at the first count
//
// docs/make_picture_quality makes docs/pictures.md with it, which says what the columns mean.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/analysis/distances.h"
#include "core/drawing/settings.h"
#include "core/image/detail.h"
#include "core/image/ink.h"
#include "core/image/tone.h"
#include "core/placing/page.h"
#include "core/text/shown_text.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"
#include "lab/analysis/seams.h"
#include "lab/compare/picture_marks.h"
#include "lab/related/plain_lloyd.h"
#include "tests/bench/page_edges.h"
#include "tests/bench/relaxed_dots.h"
#include "tests/bench/side_by_side.h"

namespace {

using namespace dapple;

constexpr double kPageMm2 = 210 * 297;
constexpr int kPeerEvenness = 50;  // steps after which Dapple's dots are about as even as the peer's
constexpr std::uint64_t kSeed = 1;
constexpr int kPanelWidth = 600;  // px

enum class Tables { all, pictures, black, seams, edges };

struct Wanted {
    std::vector<std::filesystem::path> photos;  // none: the still life
    std::vector<std::size_t> dots{5'000, 20'000, 100'000};
    std::vector<int> steps{0, 1, 2, 3, 5, 10, 20};  // beside the usual ones
    int peer_steps = 100;
    std::vector<double> loads{1.35, 1.6};  // beside the one that the program draws black with
    Tables tables = Tables::all;
    std::filesystem::path side_by_side;
};

// One drawing, judged.
struct Row {
    std::string name;
    double ms = 0;
    std::vector<glm::dvec2> dots;
    double radius = 0;  // fitted
    PictureMarks marks{};
    LocalDistances distances{};
    std::optional<PictureMarks> own_radius{};  // with the radius that the program would draw with
};

class PictureTable {
 public:
    PictureTable(const Grid<float>& light, std::size_t count)
        : even_ink_(density_of(light, Tone{}, InkCurve({.relaxing_steps = kPeerEvenness}))),
          placed_ink_(density_of(light, Tone{}, InkCurve())),
          count_(count),
          target_(target_for(light, count)) {}

    Row of_dapple(Pipeline& pipeline, int steps) const {
        RelaxedDots drawn = relaxed_dots(pipeline, count_, steps);
        Row row = judged(steps == 0 ? "Dapple, as placed" : fmt::format("Dapple, {} steps", steps), drawn.ms,
                         std::move(drawn.dots), *drawn.density, kDotsPerScale * drawn.scale);
        row.own_radius = picture_marks(row.dots, drawn.radius, target_);
        return row;
    }

    // By both ink curves. Dots tend to the root of the weight, so that plain density makes dark and light
    // more alike; the curve of dots as placed, which overlap more, has more dots in the dark and makes up for
    // it.
    std::vector<Row> of_peer(int steps) const {
        return {of_peer(LloydWeight::density, even_ink_, steps, "density"),
                of_peer(LloydWeight::density, placed_ink_, steps, "density as if placed"),
                of_peer(LloydWeight::density_squared, even_ink_, steps, "density squared")};
    }

 private:
    Row of_peer(LloydWeight weight, const Density& density, int steps, const char* what) const {
        const std::clock_t start = std::clock();
        std::vector<glm::dvec2> dots = random_dots(density, count_, kSeed);
        for (int step = 0; step < steps; ++step) lloyd_step(dots, density, weight);
        const double ms = processor_ms_since(start);
        return judged(fmt::format("random, {} plain steps, {}", steps, what), ms, std::move(dots), density,
                      dots_at_full_density(density, count_));
    }

    Row judged(std::string name, double ms, std::vector<glm::dvec2> dots, const Density& density,
               double full) const {
        Row row{.name = std::move(name), .ms = ms, .dots = std::move(dots)};
        row.radius = fitted_radius(row.dots, target_);
        row.marks = picture_marks(row.dots, row.radius, target_);
        row.distances = local_distances(row.dots, density, full);
        return row;
    }

    Density even_ink_, placed_ink_;
    std::size_t count_;
    Target target_;
};

std::string seconds(double ms) {
    return ms < 1000 ? fmt::format("{:.3f} s", ms / 1000) : fmt::format("{:.1f} s", ms / 1000);
}

void print(const Row& row) {
    const PictureMarks& m = row.marks;
    const std::string own = row.own_radius
                                ? fmt::format("{:.2f} % | {:+.2f} %", 100 * row.own_radius->tone_error,
                                              100 * row.own_radius->mean_error)
                                : " | ";
    fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} % | {:.3f} | {:.3f} | {} |\n", row.name,
               seconds(row.ms), m.ssim, fmt::join(m.ssim_by_light, " "), m.gradients, 100 * m.tone_error,
               row.distances.p1, row.distances.mean, own);
    std::fflush(stdout);
}

void print_mark(const char* mark, double value, const char* relation, double wanted, bool holds) {
    fmt::print("| {} | {:.3f} | {} {:.3f} | {} |\n", mark, value, relation, wanted, holds ? "yes" : "**no**");
}

void print_at_least(const char* mark, double value, double wanted) {
    print_mark(mark, value, "at least", wanted, value >= wanted);
}

void print_at_most(const char* mark, double value, double wanted) {
    print_mark(mark, value, "at most", wanted, value <= wanted);
}

constexpr const char* kMarksHead = "| mark | {} | wanted | reached |\n|---|---|---|---|\n";

// Against the better of the peer's rows with plain density, measure by measure.
void print_marks(const Row& dapple, const PictureMarks& a, const PictureMarks& b) {
    fmt::print("\n");
    fmt::print(fmt::runtime(kMarksHead), dapple.name);
    print_at_least("SSIM, the peer's", dapple.marks.ssim, std::max(a.ssim, b.ssim));
    print_at_least("gradients, the peer's", dapple.marks.gradients, std::max(a.gradients, b.gradients));
    print_at_most("tone error, %, half the peer's", 100 * dapple.marks.tone_error,
                  50 * std::min(a.tone_error, b.tone_error));
    print_at_least("nearest, 1st percentile", dapple.distances.p1, 0.62);
    print_at_least("nearest, mean", dapple.distances.mean, 0.84);
}

void measure(const Wanted& wanted, const Grid<float>& light, std::size_t count, Pipeline& pipeline,
             SideBySide* panels) {
    fmt::print(
        "| drawing | time | SSIM | dark to light | gradients | tone error | nearest: 1st percentile | mean | "
        "own radius: tone error | mean error |\n|---|---|---|---|---|---|---|---|---|---|\n");
    const PictureTable table(light, count);
    const auto show = [&](const Row& row) {
        if (panels) panels->add(row.dots, row.radius);
    };
    const int usual = usual_steps(double(count), kPageMm2);
    std::set<int> all(wanted.steps.begin(), wanted.steps.end());
    all.insert(usual);
    Row marked;
    for (const int steps : all) {
        Row row = table.of_dapple(pipeline, steps);
        print(row);
        if (steps == 0 || steps == usual) show(row);
        if (steps == usual) marked = std::move(row);
    }
    const std::vector<Row> peers = table.of_peer(wanted.peer_steps);
    for (const Row& peer : peers) print(peer);
    show(peers[1]);
    print_marks(marked, peers[0].marks, peers[1].marks);
}

void measure_pictures(const Wanted& wanted, Pipeline& pipeline) {
    std::vector<std::filesystem::path> photos = wanted.photos;
    if (photos.empty()) photos.emplace_back();
    bool first = true;
    for (const std::filesystem::path& photo : photos) {
        const Picture picture = photo.empty() ? sample_picture() : read_picture(photo);
        pipeline.set_light(picture.light);
        for (const std::size_t count : wanted.dots) {
            fmt::print("\n### {}, {} dots\n", photo.empty() ? "still life" : photo.filename().string(),
                       grouped(count));
            if (first && !wanted.side_by_side.empty()) {
                SideBySide panels(picture.light, kPanelWidth);
                measure(wanted, picture.light, count, pipeline, &panels);
                panels.save(wanted.side_by_side);
            } else {
                measure(wanted, picture.light, count, pipeline, nullptr);
            }
            first = false;
        }
    }
}

// Prints what a drawing in automatic tone comes to with that black, as it would be saved.
void print_black(Pipeline& pipeline, const Grid<float>& light, std::size_t count, std::optional<double> black,
                 std::optional<int> steps) {
    DrawingSettings request;
    request.tone_strength = 1;
    request.relax = steps;
    request.tone = {.detail = kAutoDetail, .black = black};
    request.placing = {.count = count, .threads = 0};
    const DrawingPlan plan = pipeline.plan(request);
    Stippling drawn;
    pipeline.draw(plan, drawn);
    const double radius = plan.radius(drawn.scale);
    std::vector<glm::dvec2> dots;
    for_each_position(drawn.dots, [&](float x, float y) { dots.emplace_back(x, y); });

    const double longer = std::max(light.width, light.height);
    const Domain page{light.width / longer, light.height / longer, Topology::window};
    const std::vector<double> nearest = nearest_distances(points_inside(dots, page), page);
    const auto overlap = std::ranges::count_if(nearest, [&](double d) { return d < 2 * radius; });

    constexpr float kDark = 0.85f;  // as ink
    const Grid<float> toned = toned_light(light, plan.tone);
    const auto is_dark = [&](float value) { return 1 - value > kDark; };
    const double dark_area =
        double(std::ranges::count_if(toned.values, is_dark)) / double(toned.values.size());
    const auto in_dark = std::ranges::count_if(dots, [&](glm::dvec2 dot) {
        return is_dark(toned.at(std::min(int(dot.x * longer), toned.width - 1),
                                std::min(int(dot.y * longer), toned.height - 1)));
    });
    const double n = double(dots.size());
    const PictureMarks marks = picture_marks(dots, radius, target_for(light, count));
    fmt::print("| {} | {}{:.2f} | {}{} | {:.3f} | {:.3f} | {:.0f} % | {:.0f} % | {:.0f} % |\n",
               grouped(count), black ? "" : "auto, ", *plan.tone.black, steps ? "" : "auto, ", plan.steps,
               marks.ssim, marks.gradients, 100 * dark_area, 100 * double(in_dark) / n,
               100 * double(overlap) / n);
    std::fflush(stdout);
}

void measure_black(const Wanted& wanted, Pipeline& pipeline) {
    std::vector<std::filesystem::path> photos = wanted.photos;
    if (photos.empty()) photos.emplace_back();
    for (const std::filesystem::path& photo : photos) {
        const Picture picture = photo.empty() ? sample_picture() : read_picture(photo);
        pipeline.set_light(picture.light);
        fmt::print(
            "\n### Automatic: {}\n| dots | black | steps | SSIM | gradients | dark area | dots there | dots "
            "that overlap |\n|---|---|---|---|---|---|---|---|\n",
            photo.empty() ? "still life" : photo.filename().string());
        for (const std::size_t count : wanted.dots) {
            print_black(pipeline, picture.light, count, {}, kFewestUsualSteps);
            for (const std::optional<double> black : {std::optional<double>{}, {1.0}, {0.9}, {0.8}})
                print_black(pipeline, picture.light, count, black, {});
        }
    }
}

void measure_seams(const Wanted& wanted, Pipeline& pipeline) {
    pipeline.set_plain(Density(Grid<float>(1, 1, 1.0f)));
    fmt::print(
        "\n### Seams on black\n| dots | steps | load | bare paper | borders of 1/2 | 1/4 | 1/8 | worst "
        "|\n|---|---|---|---|---|---|---|---|\n");
    double worst_marked = 0;
    for (const std::size_t count : {65'536, 90'000, 140'000, 262'144}) {
        for (const int steps : wanted.steps) {
            if (steps == 1 || steps == 2) continue;
            const RelaxedDots drawn = relaxed_dots(pipeline, count, steps);
            const double own = std::numbers::pi * drawn.radius * drawn.radius * double(count);
            std::vector<double> loads{own};
            loads.insert(loads.end(), wanted.loads.begin(), wanted.loads.end());
            for (std::size_t i = 0; i < loads.size(); ++i) {
                const Seams seen = seams(drawn.dots, loads[i]);
                fmt::print("| {} | {} | {:.2f}{} | {:.2f} % | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n",
                           grouped(count), steps, loads[i], i == 0 ? ", own" : "", 100 * seen.bare,
                           seen.of_halves, seen.of_quarters, seen.of_eighths, seen.worst());
                std::fflush(stdout);
                if (steps == kFewestUsualSteps && i == 0) worst_marked = std::max(worst_marked, seen.worst());
            }
        }
    }
    if (worst_marked == 0) return;
    fmt::print("\n");
    fmt::print(fmt::runtime(kMarksHead), fmt::format("Dapple, {} steps", kFewestUsualSteps));
    print_at_most("worst seam at its own load", worst_marked, 2);
}

// How dots lie along the page's edges, on grey and in photographs.
void measure_edges(const Wanted& wanted, Pipeline& pipeline) {
    fmt::print(
        "| picture | dots | steps | 1st band | 2nd | 3rd | 4th | 5th | 6th | peak along the edge | inside "
        "|\n");
    fmt::print("|---|---|---|---|---|---|---|---|---|---|---|\n");
    const auto print_rows = [&](const std::string& name) {
        for (const std::size_t dots : wanted.dots) {
            for (const int steps : wanted.steps) {
                const PageEdges edges = page_edges(relaxed_dots(pipeline, dots, steps));
                fmt::print("| {} | {} | {} |", name, grouped(dots), steps);
                for (const double band : edges.bands) fmt::print(" {:.2f} |", band);
                fmt::print(" {:.1f} | {:.1f} |\n", edges.peak, edges.peak_inside);
            }
        }
    };
    for (const auto& photo : wanted.photos) {
        pipeline.set_light(read_picture(photo).light);
        print_rows(photo.stem().string());
    }
    pipeline.set_plain(page_density(Grid<float>(1000, 1000, 0.5f)));
    print_rows("grey");
}

Wanted wanted_by(int argc, char** argv) {
    Wanted wanted;
    CLI::App app("How good pictures are, beside a peer's.");
    app.add_option("PHOTO", wanted.photos, "photographs; none: the built-in still life");
    app.add_option("--dots", wanted.dots, "numbers of dots")->delimiter(',')->allow_extra_args(false);
    app.add_option("--steps", wanted.steps, "steps of relaxation; 0: as placed")
        ->delimiter(',')
        ->allow_extra_args(false);
    app.add_option("--peer-steps", wanted.peer_steps, "the peer's plain steps");
    app.add_option("--loads", wanted.loads, "dots' area on black, over the page's")
        ->delimiter(',')
        ->allow_extra_args(false);
    app.add_option("--only", wanted.tables, "pictures, black, seams or edges")
        ->transform(CLI::CheckedTransformer(std::map<std::string, Tables>{{"pictures", Tables::pictures},
                                                                          {"black", Tables::black},
                                                                          {"seams", Tables::seams},
                                                                          {"edges", Tables::edges}}));
    app.add_option("--side-by-side", wanted.side_by_side, "a PNG of the first photograph's drawings");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error));
    }
    return wanted;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Wanted wanted = wanted_by(argc, argv);
        Pipeline pipeline;
        pipeline.set_tile(tile_named(kDefaultTile));
        const auto wants = [&](Tables one) { return wanted.tables == Tables::all || wanted.tables == one; };
        if (wants(Tables::pictures)) measure_pictures(wanted, pipeline);
        if (wants(Tables::black)) measure_black(wanted, pipeline);
        if (wants(Tables::seams)) measure_seams(wanted, pipeline);
        if (wanted.tables == Tables::edges) measure_edges(wanted, pipeline);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "picture_quality: {}\n", error.what());
        return 1;
    }
}
