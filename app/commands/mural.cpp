#include "app/commands/mural.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "app/commands/render_report.h"
#include "app/files/sheet_files.h"
#include "app/progress_line.h"

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
        render_parts(parts, {.progress = show}, [&](const RenderOptions& part, const Rendered& rendered) {
            page = rendered.whole_page;
            found.push_back({name_of(part.sheet), rendered.findings});
            if (options.stats) stats.push_back(stats_of(part, rendered));
            ++drawn;
        });
    }
    if (parts.empty()) return;
    if (options.share.index == 0) save_assembly_plan(options.output, page, sheets);
    const bool by_pen = options.saving.pen_files && options.drawing.pens.set != PenSet::one;
    fmt::print(stderr, "{}: {}{}\n", sheets_in_words(page, sheets),
               sheet_files_in_words(options.output, sheets), by_pen ? ", a file for each pen" : "");
    for (const std::string& line : findings_among(found)) fmt::print(stderr, "{}\n", line);
    if (options.stats) save_stats(*options.stats, stats_of_all(stats));
}

}  // namespace dapple
