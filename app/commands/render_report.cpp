#include "app/commands/render_report.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "core/tile/tile_file.h"
#include "io/command_line/options.h"
#include "io/files/atomic_file.h"
#include "io/files/save_drawing.h"
#include "io/files/separations.h"

namespace dapple {
namespace {

using Json = nlohmann::ordered_json;

// The size of the drawing that was saved, or of the files that each pen has in its place; none for the
// standard output or a pipe.
std::optional<std::uint64_t> bytes_written(const RenderOptions& options, const Rendered& drawn) {
    if (is_standard_stream(options.output)) return std::nullopt;
    std::vector<std::filesystem::path> files{options.output};
    const DrawingFormat format = format_of(options);
    if (has_pen_files(format, options.saving, drawn.pens))
        files = files_of(options.output, format, options.saving, drawn.pens);
    std::uint64_t bytes = 0;
    for (const std::filesystem::path& file : files) {
        std::error_code error;
        bytes += std::filesystem::file_size(file, error);
        if (error) return std::nullopt;
    }
    return bytes;
}

void print_pens(const Rendered& drawn) {
    for (const PenFigures& figures : drawn.by_pen) {
        const Pen& pen = drawn.pens[static_cast<std::size_t>(figures.pen)];
        const std::string time = drawn.plotting ? ", " + time_in_words(figures.time.total_s()) : "";
        fmt::print(stderr, "  {} {}: {}{}\n", figures.pen + 1, pen.name, dots_in_words(figures.dots), time);
    }
}

Json json_of(const LocalDistances& distances) {
    return {{"p1", distances.p1}, {"mean", distances.mean}};
}

Json pens_json(const Rendered& drawn) {
    auto all = Json::array();
    for (const PenFigures& figures : drawn.by_pen) {
        const auto i = static_cast<std::size_t>(figures.pen);
        const Pen& pen = drawn.pens[i];
        Json one{{"name", pen.name},
                 {"colour", hex_of(pen.colour)},
                 {"width_mm", pen.width_mm},
                 {"gap_mm", pen.gap_mm},
                 {"gain_mm", pen.gain_mm},
                 {"dots", figures.dots},
                 {"pen_up_m", figures.pen_up_m},
                 {"nearest_mm", figures.nearest_mm},  // null if there are not two
                 {"nearer_than_gap", figures.nearer_than_gap},
                 {"total_s", figures.time.total_s()}};
        if (drawn.evenness) {
            one["wanted"] = drawn.evenness->each[i].wanted;
            one["nearest"] = json_of(drawn.evenness->each[i].distances);
        }
        all.push_back(std::move(one));
    }
    return all;
}

std::string strokes_in_words(const StrokeFigures& strokes, DrawingStyle style) {
    const bool one = strokes.strokes == 1;
    if (strokes.drawn_m == 0)
        return one ? "touches the paper once"
                   : fmt::format("touches the paper {} times", grouped(strokes.strokes));
    const std::string longest =
        style == DrawingStyle::line
            ? fmt::format(", at most {} from dot to dot", millimetres_in_words(strokes.longest_mm))
            : "";
    return fmt::format("draws {} {} of {}{}", grouped(strokes.strokes), one ? "line" : "lines",
                       way_in_words(strokes.drawn_m), longest);
}

}  // namespace

bool prints_advice(const RenderOptions& options) {
    return options.advice || options.saving.machine || is_for_machines(format_of(options));
}

void print_summary(const RenderOptions& options, const Rendered& drawn) {
    const std::optional<std::uint64_t> bytes = bytes_written(options, drawn);
    const std::string size = !bytes ? "" : ", " + bytes_in_words(static_cast<double>(*bytes));
    // The ways from one pen's dots to the next one's are in one of the two only.
    const bool shortened =
        drawn.curve_way_m && drawn.preflight && *drawn.curve_way_m > 1.01 * drawn.preflight->pen_up_m;
    const std::string saved =
        shortened ? fmt::format(" ({} unoptimised)", way_in_words(*drawn.curve_way_m))
        : drawn.plotting && drawn.order == DotOrder::space && !options.saving.order
            ? " (along a curve, for this many dots; --order shortest finds a shorter route)"
            : "";
    const bool alike =
        !has_several_sizes(options.drawing) && drawn.pens.empty() && !draws_strokes(options.drawing);
    const std::string wide =
        alike && drawn.dots > 0 ? fmt::format(", {} wide", millimetres_in_words(2 * drawn.radius_mm)) : "";
    const std::string dots = dots_in_words(drawn.dots) + size + wide;
    if (drawn.dots == 0)
        fmt::print(stderr, "{}: this is all bare paper\n", dots);
    else if (drawn.pixels.x > 0)
        fmt::print(stderr, "{}; {} x {} pixels\n", dots, drawn.pixels.x, drawn.pixels.y);
    else if (!prints_advice(options))
        fmt::print(stderr, "{}\n", dots);
    else if (const auto& strokes = drawn.strokes)
        fmt::print(stderr, "{}; the pen {}{}{}\n", dots, strokes_in_words(*strokes, options.drawing.style),
                   strokes->strokes > 1
                       ? fmt::format(", and moves {} between them", way_in_words(strokes->pen_up_m))
                       : "",
                   strokes->drawn_m == 0 || saved.empty() || !drawn.preflight
                       ? saved
                       : fmt::format("; pen travel {}{}", way_in_words(drawn.preflight->pen_up_m), saved));
    else if (drawn.preflight && drawn.dots > 1)
        fmt::print(stderr, "{}{}; the nearest are {} apart\n", dots,
                   drawn.plotting ? fmt::format("; the pen moves {} between them{}",
                                                way_in_words(drawn.preflight->pen_up_m), saved)
                                  : "",
                   millimetres_in_words(drawn.preflight->nearest_mm));
    else
        fmt::print(stderr, "{}\n", dots);
    if (!prints_advice(options)) return;
    if (drawn.plotting && drawn.dots > 0) {
        const std::size_t changes = drawn.by_pen.empty() ? 0 : drawn.by_pen.size() - 1;
        const std::string pauses =
            changes == 0 ? ""
                         : fmt::format(", and the pen is changed {}",
                                       changes == 1 ? "once" : fmt::format("{} times", changes));
        fmt::print(stderr, "{} on {}: {}{}\n", time_in_words(drawn.plotting->total_s()),
                   words_for(drawn.machine), what_takes_longest(*drawn.plotting), pauses);
    }
    print_pens(drawn);
    for (const Finding& finding : drawn.findings) {
        // The line above has said how long it takes.
        const bool timed = finding.kind == FindingKind::hours;
        fmt::print(stderr, "{}\n", timed ? finding.cure : sentence_of(finding));
    }
}

std::vector<std::string> findings_among(std::span<const NamedFindings> drawings) {
    struct Kind {
        FindingKind kind;
        std::size_t drawings = 0;
        std::string first;
    };
    std::vector<Kind> kinds;
    for (const NamedFindings& drawing : drawings) {
        std::vector<FindingKind> seen;  // a drawing may have several of a kind
        for (const Finding& finding : drawing.findings) {
            if (std::ranges::find(seen, finding.kind) != seen.end()) continue;
            seen.push_back(finding.kind);
            auto kind = std::ranges::find(kinds, finding.kind, &Kind::kind);
            if (kind == kinds.end())
                kind = kinds.insert(kinds.end(), {finding.kind, 0,
                                                  fmt::format("{}: {}", drawing.name, sentence_of(finding))});
            ++kind->drawings;
        }
    }
    std::ranges::sort(kinds, {}, &Kind::kind);
    std::vector<std::string> lines;
    for (const Kind& kind : kinds) {
        const std::size_t others = kind.drawings - 1;
        lines.push_back(kind.first +
                        (others == 0 ? "" : fmt::format(" (and {} more like it)", grouped(others))));
    }
    return lines;
}

std::string stats_of(const RenderOptions& options, const Rendered& drawn) {
    const DrawingSettings& settings = options.drawing;
    const Tone& tone = drawn.tone;
    const int threads = settings.placing.threads;
    Json distinct, duplicates, preflight, plotting, strokes;  // null where there is none
    if (drawn.duplicates) {
        distinct = drawn.dots - *drawn.duplicates;
        duplicates = *drawn.duplicates;
    }
    if (drawn.preflight) {
        const Preflight& found = *drawn.preflight;
        preflight = {{"pen_up_m", found.pen_up_m},
                     {"pen_up_before_m", drawn.curve_way_m ? Json(*drawn.curve_way_m) : Json()},
                     {"nearest_mm", found.nearest_mm},  // null if there are not two
                     {"nearer_than_0.5_mm", found.nearer_than_saxi},
                     {"nearer_than_0.152_mm", found.nearer_than_axidraw},
                     {"over_the_edge", found.over_edge},
                     {"outside_the_margins", found.outside_margins},
                     {"overlapping", found.overlapping},
                     {"rings_m", found.rings_m}};
    }
    auto findings = Json::array();
    for (const Finding& finding : drawn.findings)
        findings.push_back({{"kind", name_of(finding.kind)}, {"text", finding.text}, {"cure", finding.cure}});
    if (drawn.plotting)
        plotting = {{"machine", name_of(drawn.machine)},      {"moving_s", drawn.plotting->moving_s},
                    {"lifting_s", drawn.plotting->lifting_s}, {"dots_s", drawn.plotting->dots_s},
                    {"drawing_s", drawn.plotting->drawing_s}, {"total_s", drawn.plotting->total_s()}};
    if (drawn.strokes)
        strokes = {{"count", drawn.strokes->strokes},
                   {"drawn_m", drawn.strokes->drawn_m},
                   {"longest_mm", drawn.strokes->longest_mm},
                   {"pen_up_m", drawn.strokes->pen_up_m}};
    const Json toned{{"automatic", settings.automatic_tone},
                     {"strength", settings.tone_strength},
                     {"exposure", tone.exposure},
                     {"black_point", tone.black_point},
                     {"white_point", tone.white_point},
                     {"contrast", tone.contrast},
                     {"brightness", tone.brightness},
                     {"gamma", tone.gamma},
                     {"blur", tone.blur},
                     {"detail", tone.detail},
                     {"black", tone.black.value_or(1)},
                     {"invert", tone.invert}};
    const auto [top, right, bottom, left] = settings.page.margins.value_or(Margins{});
    Json margin = top;
    if (!settings.page.margins)
        margin = "auto";
    else if (settings.page.margins != Margins{top, top, top, top})
        margin = {top, right, bottom, left};
    const Json stats{
        {"image", options.image ? options.image->string() : "sample"},
        {"image_width", drawn.width},
        {"image_height", drawn.height},
        {"output", options.output.string()},
        {"dots", distinct},
        {"emitted", drawn.dots},
        {"duplicates", duplicates},
        {"scale", drawn.scale},
        {"mean_density", drawn.mean_density},
        {"tone", toned},
        {"relaxing_steps", drawn.steps},
        {"placer", name_of(settings.placer)},
        {"tile", tile_in_use(settings)},
        {"ranking", name_of(settings.ranking)},
        {"width_mm", drawn.page.width_mm},
        {"height_mm", drawn.page.height_mm},
        {"dot_radius_mm", drawn.radius_mm},
        {"page", name_of(settings.page.paper)},
        {"margin_mm", margin},
        {"picture_mm",
         {drawn.picture.low.x, drawn.picture.low.y, drawn.picture.size().x, drawn.picture.size().y}},
        {"order", name_of(drawn.order)},
        {"preflight", preflight},
        {"findings", findings},
        {"plotting", plotting},
        {"style", name_of(settings.style)},
        {"dot_shape", text_of(settings.mark)},
        {"strokes", strokes},
        {"pens", pens_json(drawn)},
        {"nearest", drawn.evenness ? json_of(drawn.evenness->all) : Json()},
        {"file_bytes", bytes_written(options, drawn).value_or(0)},
        {"threads", threads > 0 ? threads : tbb::info::default_concurrency()},
        {"tile_ms", drawn.times.tile},
        {"read_ms", drawn.times.read},
        {"tone_ms", drawn.times.tone},
        {"place_ms", drawn.times.place},
        {"order_ms", drawn.times.order},
        {"write_ms", drawn.times.write},
        {"check_ms", drawn.times.check},
    };
    // File names need not be UTF-8, JSON has to be.
    return stats.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string stats_of_all(std::span<const std::string> stats) {
    std::string all = "[\n";
    for (std::size_t i = 0; i < stats.size(); ++i) {
        const std::string_view one = stats[i];
        all += one.substr(0, one.find_last_not_of('\n') + 1);
        all += i + 1 < stats.size() ? ",\n" : "\n";
    }
    return all + "]\n";
}

void check_stats(const RenderOptions& options) {
    if (options.stats && !is_standard_stream(*options.stats)) check_can_save(*options.stats);
}

void save_stats(const std::filesystem::path& where, const std::string& stats) {
    if (is_standard_stream(where))
        std::cout << stats;
    else
        save_atomically(where, [&](std::ostream& out) { out << stats; });
}

}  // namespace dapple
