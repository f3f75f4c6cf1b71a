#include "app/commands/reproduce.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "app/files/atomic_file.h"
#include "app/reproduce/figures.h"
#include "app/shown_text.h"
#include "core/reports/html.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        throw std::runtime_error(fmt::format("{}: is a file, not a folder; name a folder", folder.string()));
    fs::create_directory(folder, error);
    if (error)
        throw std::runtime_error(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
}

void add_table(HtmlPage& page, const std::vector<ComparedNumber>& rows, const char* expected) {
    std::vector<HtmlPage::Row> cells;
    for (const ComparedNumber& row : rows)
        cells.push_back({.cells = {row.what, row.source, row.expected, row.ours, row.equal() ? "yes" : "NO"},
                         .kind = row.equal() ? HtmlPage::RowKind::good : HtmlPage::RowKind::bad});
    page.table({"What", "Source", expected, "Ours", "Equal?"}, cells);
}

std::string numbers_json(const std::vector<ComparedNumber>& rows) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const ComparedNumber& row : rows)
        json.push_back({{"what", row.what},
                        {"source", row.source},
                        {"expected", row.expected},
                        {"ours", row.ours},
                        {"equal", row.equal()}});
    return json.dump(2) + '\n';
}

void save_text(const fs::path& file, const std::string& text) {
    save_atomically(
        file, [&](std::ostream& out) { out.write(text.data(), static_cast<std::streamsize>(text.size())); });
}

}  // namespace

void check_equal(std::span<const ComparedNumber> rows, const fs::path& page) {
    const auto differ = std::ranges::count_if(rows, [](const ComparedNumber& row) { return !row.equal(); });
    if (differ == 0) return;
    throw std::runtime_error(
        fmt::format("{} of {} numbers differ from what should come out; they are marked in {}", differ,
                    rows.size(), page.string()));
}

void reproduce(const ReproduceOptions& options) {
    make_folder(options.folder);
    const fs::path page_file = options.folder / "index.html", numbers_file = options.folder / "numbers.json";
    check_can_save(page_file);
    check_can_save(numbers_file);

    HtmlPage page("A self-similar hierarchical tile, made again");
    page.paragraph(
        "The figures and numbers of A. Lagae and P. Dutré, \"Generating Well-Distributed Point Sets with a "
        "Self-Similar Hierarchical Tile\" (2006), worked out from scratch by dapple reproduce. Nothing here "
        "is copied from the paper but the numbers in the column headed so.");

    const std::vector<ComparedNumber> printed = compare_printed_numbers();
    const std::vector<ComparedNumber> counts = compare_figure8_counts();
    const std::vector<ComparedNumber> larger = compare_larger_tiles();
    page.heading("Table 1: numbers that the paper prints");
    add_table(page, printed, "Printed");
    page.paragraph(
        "The printed Table 1 was not at hand; this one has the numbers of section 4, figure 1 and Appendix A "
        "in its place. The relative radius is half the smallest distance between two points, over that of "
        "the densest packing. A balanced sequence has as many ones as zeros: only such words can make a tile "
        "with a quarter of its points in each quadrant.");
    page.heading("Figure 8, run");
    add_table(page, counts, "By hand");
    page.paragraph(
        "The printed algorithm tests the points that a tile shares with its parent again, so about a quarter "
        "of what it emits is there already.");
    page.heading("Beyond the paper");
    add_table(page, larger, "Recorded");
    page.paragraph(
        "The paper's search took 8 minutes for 16 points and three and a half days for 20. With branch and "
        "bound, 24 and 28 points take seconds.");

    add_tile_figures(page);
    add_recursion_figures(page);
    add_stippling_figures(page);
    add_light_figures(page, options.environments);

    std::vector<ComparedNumber> all = printed;
    all.insert(all.end(), counts.begin(), counts.end());
    all.insert(all.end(), larger.begin(), larger.end());
    save_text(numbers_file, numbers_json(all));
    save_text(page_file, page.text());
    check_equal(all, page_file);
    fmt::print("All {} numbers are equal; the figures are in {}.\n", all.size(),
               printable(page_file.native()));
}

ReproduceCommand::ReproduceCommand(CLI::App& program) {
    CLI::App* const command = program.add_subcommand(
        "reproduce", "Make every figure and number of the paper from scratch, as a page to look at");
    command
        ->add_option("-o,--output", options_.folder,
                     "A folder for index.html and numbers.json, made if missing")
        ->type_name("DIR")
        ->required();
    command
        ->add_option("--environment", options_.environments,
                     "Latitude-longitude maps (.hdr, .exr) for figure 7; without any, a sky of our own")
        ->type_name("MAP");
    command->footer(
        "Ends with an error if a number differs from the paper's.\n\n"
        "Examples:\n"
        "  dapple reproduce -o paper\n"
        "  dapple reproduce -o paper --environment hall.hdr venice.hdr");
    command->callback([this] { reproduce(options_); });
}

}  // namespace dapple
