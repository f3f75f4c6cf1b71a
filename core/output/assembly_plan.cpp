#include "core/output/assembly_plan.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "core/text/xml_text.h"

namespace dapple {
namespace {

// All in millimetres.
constexpr double kPaperWidth = 210, kPaperHeight = 297, kBorder = 15;
constexpr double kPictureTop = 35, kPictureHeight = 165;
constexpr double kTextSize = 4, kLineHeight = 6;

void write_box(std::ostream& out, glm::dvec2 corner, glm::dvec2 size, std::string_view style) {
    fmt::print(out,
               R"(<rect x="{:.3f}" y="{:.3f}" width="{:.3f}" height="{:.3f}" {}/>)"
               "\n",
               corner.x, corner.y, size.x, size.y, style);
}

void write_text(std::ostream& out, glm::dvec2 at, double size, std::string_view style,
                std::string_view text) {
    fmt::print(out,
               R"(<text x="{:.3f}" y="{:.3f}" font-size="{:.3f}" {}>{}</text>)"
               "\n",
               at.x, at.y, size, style, xml_text(text));
}

// The steps, in lines that fit the paper.
std::vector<std::string> steps_for(const AssemblyPlan& plan) {
    const Sheet& sheets = plan.sheets;
    const double overlap = sheets.overlap_mm;
    std::vector<std::string> lines{"1. Print or plot each file at 100 %, never fitted to the paper."};
    if (overlap > 0) {
        if (sheets.columns > 1)
            lines.push_back(
                fmt::format("2. From column B on, cut {:g} mm off each sheet's left side, along "
                            "the marks.",
                            overlap / 2));
        if (sheets.rows > 1)
            lines.push_back(fmt::format("{} From row 2 on, cut {:g} mm off each sheet's upper side.",
                                        sheets.columns > 1 ? "   " : "2.", overlap / 2));
        lines.push_back(
            "3. Join each row: lay the cut side of a sheet on the marks of the one to its left, so");
        lines.push_back(
            "   that the drawing meets in the strip that both have, and glue it onto that strip.");
        lines.push_back("4. Join the rows in the same way, from the top down.");
    } else {
        lines.push_back(
            "2. Cut away bare paper around the drawing. The sheets share no strip: lay them edge to");
        lines.push_back(
            "   edge, each row from the left and the rows from the top, and tape them from behind.");
    }
    return lines;
}

}  // namespace

void write_assembly_plan(std::ostream& out, const AssemblyPlan& plan) {
    const PageSize& page = plan.page;
    const Sheet& sheets = plan.sheets;
    const glm::dvec2 whole(page.width_mm, page.height_mm), step = sheet_step(page, sheets);
    const PageSize one = sheet_of(page, sheets).size;
    const glm::dvec2 size(one.width_mm, one.height_mm);
    const double scale = std::min((kPaperWidth - 2 * kBorder) / whole.x, kPictureHeight / whole.y);
    const glm::dvec2 corner((kPaperWidth - whole.x * scale) / 2, kPictureTop);

    fmt::print(out,
               R"(<?xml version="1.0" encoding="UTF-8"?>)"
               "\n"
               R"(<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="{0:g}mm" height="{1:g}mm" )"
               R"(viewBox="0 0 {0:g} {1:g}" font-family="sans-serif">)"
               "\n",
               kPaperWidth, kPaperHeight);
    write_box(out, {0, 0}, {kPaperWidth, kPaperHeight}, R"(fill="#ffffff")");
    write_text(out, {kBorder, 18}, 6, R"(font-weight="bold")", "How the sheets of " + plan.name + " join");
    const bool several = sheets.columns * sheets.rows > 1;
    write_text(out, {kBorder, 26}, kTextSize, "",
               fmt::format("{:.5g} x {:.5g} mm on {} sheet{} of {:.5g} x {:.5g} mm", whole.x, whole.y,
                           sheets.columns * sheets.rows, several ? "s" : "", size.x, size.y));

    write_box(out, corner, whole * scale, R"(fill="#f7f7f7" stroke="#000000" stroke-width="0.4")");
    const double overlap = sheets.overlap_mm * scale;
    for (int column = 1; column < sheets.columns; ++column)
        write_box(out, corner + glm::dvec2(step.x * column * scale, 0), {overlap, whole.y * scale},
                  R"(fill="#c8c8c8")");
    for (int row = 1; row < sheets.rows; ++row)
        write_box(out, corner + glm::dvec2(0, step.y * row * scale), {whole.x * scale, overlap},
                  R"(fill="#c8c8c8")");
    constexpr std::string_view kCut = R"(stroke="#000000" stroke-width="0.3" stroke-dasharray="2 1.2")";
    const auto write_cut = [&](glm::dvec2 from, glm::dvec2 to) {
        fmt::print(out,
                   R"(<path d="M{:.3f} {:.3f}L{:.3f} {:.3f}" {}/>)"
                   "\n",
                   from.x, from.y, to.x, to.y, kCut);
    };
    for (int column = 1; column < sheets.columns; ++column) {
        const double x = corner.x + step.x * column * scale + overlap / 2;
        write_cut({x, corner.y}, {x, corner.y + whole.y * scale});
    }
    for (int row = 1; row < sheets.rows; ++row) {
        const double y = corner.y + step.y * row * scale + overlap / 2;
        write_cut({corner.x, y}, {corner.x + whole.x * scale, y});
    }
    const double letters = std::min({0.4 * step.y * scale, 0.25 * step.x * scale, 12.0});
    for (int row = 1; row <= sheets.rows; ++row) {
        for (int column = 1; column <= sheets.columns; ++column) {
            const glm::dvec2 middle = glm::dvec2(step.x * (column - 1), step.y * (row - 1)) + size / 2.0;
            write_text(out, corner + middle * scale + glm::dvec2(0, 0.35 * letters), letters,
                       R"(text-anchor="middle")", name_of(Sheet{column, row, sheets.columns, sheets.rows}));
        }
    }

    std::vector<std::string> lines{
        fmt::format("A1 is the file {0}-A1{1}; letters are columns from the left, numbers rows from the top.",
                    plan.name, plan.ending)};
    if (sheets.overlap_mm > 0)
        lines.push_back(
            fmt::format("Grey: the {:g} mm that neighbours share. Dashed: where to cut.", sheets.overlap_mm));
    if (several)
        lines.push_back(
            fmt::format("The next sheet begins {:.5g} mm further right, or {:.5g} mm further "
                        "down.",
                        step.x, step.y));
    for (std::string& line : steps_for(plan)) lines.push_back(std::move(line));
    double y = kPictureTop + kPictureHeight + 14;
    for (const std::string& line : lines) {
        write_text(out, {kBorder, y}, kTextSize, R"(xml:space="preserve")", line);
        y += kLineHeight;
    }
    out << "</svg>\n";
}

}  // namespace dapple
