#include "app/commands/mural.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands/render_report.h"
#include "core/text/shown_text.h"
#include "io/command_line/options.h"
#include "io/files/atomic_file.h"
#include "io/files/sheet_files.h"
#include "io/progress_line.h"

namespace dapple {

void add_mural_options(CLI::App& app, Sheet& sheets) {
    const auto read_sheets = [&](const std::string& text) {
        const Sheet read = parse_sheets(text);
        sheets.columns = read.columns;
        sheets.rows = read.rows;
    };
    add_text(app, "--sheets", "CxR", read_sheets,
             "All sheets of a mural, each in a file: 3x4 -o mural.svg makes mural-A1.svg to mural-C4.svg, of "
             "3 columns and 4 rows, and mural-plan.svg, which shows how they join")
        ->group("Page");
    add_length(app, setting::overlap, sheets.overlap_mm)->group("Page");
}

void tell_of_no_share(const WorkShare& share, std::size_t count, const char* things) {
    fmt::print(stderr, "none of the {} {} is in share {} of {}; nothing was drawn\n", count, things,
               share.index + 1, share.of);
}

void render_mural(const RenderOptions& options) {
    const Sheet& sheets = options.drawing.sheets;
    std::vector<RenderOptions> parts;
    std::size_t number = 0;
    for (const Sheet& sheet : all_sheets(sheets)) {
        if (!options.share.has(number++)) continue;
        RenderOptions& part = parts.emplace_back(options);
        part.sheet = sheet;
        part.output = sheet_file(options.output, name_of(sheet));
        part.stats.reset();
    }
    if (parts.empty()) {
        tell_of_no_share(options.share, number, "sheets");
        return;
    }
    PageSize page;
    std::size_t drawn = 0;
    std::vector<NamedFindings> found;
    std::vector<std::string> stats;
    check_stats(options);
    {
        ProgressLine line;
        const auto show = [&](double share) {
            line.show((static_cast<double>(drawn) + share) / static_cast<double>(parts.size()),
                      fmt::format("{} of {} sheets drawn", drawn, parts.size()));
        };
        const auto take = [&](const RenderOptions& part, const Rendered& rendered) {
            page = rendered.whole_page;
            found.push_back({name_of(part.sheet), rendered.findings});
            if (options.stats) stats.push_back(stats_of(part, rendered));
            ++drawn;
        };
        try {
            render_parts(parts, {.progress = show}, take);
        } catch (const std::runtime_error&) {
            save_next(drawn, [] { throw; });
        }
    }
    const bool writes_plan = options.share.index == 0;
    if (writes_plan) save_next(drawn, [&] { save_assembly_plan(options.output, page, sheets); });
    const bool by_pen = options.saving.pen_files && options.drawing.pens.set != PenSet::one;
    const char* const each_pen = by_pen ? ", a file for each pen" : "";
    if (options.share.of > 1) {
        std::vector<std::string> names;
        for (const RenderOptions& part : parts) names.push_back(printable(part.output.native()));
        fmt::print(stderr, "{} of {}: {}{}; {}\n", drawn, sheets_in_words(page, sheets),
                   fmt::join(names, ", "), each_pen,
                   writes_plan ? printable(plan_file(options.output).native()) + " shows how they join"
                               : std::string("the plan is written with share 1"));
    } else {
        fmt::print(stderr, "{}: {}{}\n", sheets_in_words(page, sheets),
                   sheet_files_in_words(options.output, sheets), each_pen);
    }
    for (const std::string& line : findings_among(found)) fmt::print(stderr, "{}\n", line);
    if (options.stats) save_stats(*options.stats, stats_of_all(stats));
}

}  // namespace dapple
