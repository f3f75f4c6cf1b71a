#include "core/output/test_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/failure.h"

namespace dapple {
namespace {

constexpr double kBorderMm = 14;  // around all, with the registration marks in it
constexpr int kSingles = 10, kAlike = 3;
constexpr std::array kTones{10, 25, 50, 75, 90, 100};

// In millimetres, of a pen.
struct Sizes {
    double letter, pair_step, column, patch;
};

Sizes sizes_for(double width) {
    const double letter = std::clamp(5 * width, 2.0, 4.0);
    return {.letter = letter,
            .pair_step = std::max(1.2, 3 * width),
            .column = text_width_mm("0.00", letter) + 1.5 * letter,
            .patch = std::clamp(12 * width, 2.5, 15.0)};
}

// 1, 2 or 5 times a power of ten, in millimetres, and at least so much; no machine is finer than a hundredth.
double round_step(double least) {
    for (double ten = 0.01;; ten *= 10)
        for (const double times : {1, 2, 5})
            if (times * ten >= least * (1 - 1e-9)) return times * ten;
}

class Drawn {
 public:
    Drawn(TestSheet& sheet, int pen) : sheet_(sheet), pen_(pen) {}

    void dot(glm::dvec2 at) {
        sheet_.strokes.points.push_back(at);
        end_stroke(sheet_.strokes, pen_);
        ++sheet_.dots;
    }
    void text(std::string_view text, glm::dvec2 corner, double height) {
        add_text(sheet_.strokes, text, corner, height, pen_);
    }

 private:
    TestSheet& sheet_;
    int pen_;
};

// Dots on a hexagonal lattice, which overlap last, and to and fro. All of the paper is covered once each
// three of them meet in a point.
void draw_tone(Drawn& drawn, glm::dvec2 corner, double side, double dot_width, int per_cent) {
    const double radius = dot_width / 2, area = std::numbers::pi * radius * radius;
    const double step = per_cent == 100 ? std::numbers::sqrt3 * radius
                                        : std::sqrt(2 * area / (std::numbers::sqrt3 * (per_cent / 100.0)));
    const double row_step = step * std::numbers::sqrt3 / 2;
    const auto columns = std::lround(side / step), rows = std::lround(side / row_step);
    for (long row = 0; row < rows; ++row)
        for (long k = 0; k < columns; ++k) {
            const long column = row % 2 == 0 ? k : columns - 1 - k;
            const double shift = row % 2 == 0 ? 0.25 : 0.75;
            drawn.dot(corner + glm::dvec2((static_cast<double>(column) + shift) * step,
                                          (static_cast<double>(row) + 0.5) * row_step));
        }
}

// The gaps of a pen's pairs that lie side by side on a sheet so wide, in millimetres, from 0 on.
std::vector<double> tested_gaps(double pen_width_mm, double room_mm) {
    constexpr double kMostOfWidth = 0.75;
    constexpr std::size_t kMostGaps = 16;
    const auto fit = static_cast<std::size_t>(room_mm / sizes_for(pen_width_mm).column);
    const std::size_t count = std::clamp<std::size_t>(fit, 2, kMostGaps);
    const double step = round_step(kMostOfWidth * pen_width_mm / static_cast<double>(count));
    std::vector<double> gaps;
    for (std::size_t i = 0; i < count; ++i) gaps.push_back(static_cast<double>(i) * step);
    return gaps;
}

// Returns how high the block is.
double draw_block(Drawn drawn, const Pen& pen, int number, glm::dvec2 corner, double room) {
    const auto [letter, pair_step, column, patch] = sizes_for(pen.width_mm);
    const double width = pen.width_mm;
    const std::string gain = pen.gain_mm > 0 ? fmt::format("+{:g}", pen.gain_mm) : "";
    const std::string title = fmt::format("{} {} {:g}{} mm", number, pen.name, width, gain);
    const double singles = room / 2;
    const double title_height =
        std::min(letter, letter * (room - singles - letter) / text_width_mm(title, letter));
    drawn.text(title, corner, title_height);
    for (int i = 0; i < kSingles; ++i)
        drawn.dot(corner + glm::dvec2(room - singles + i * singles / kSingles, letter / 2));

    double y = corner.y + 1.8 * letter + width / 2;
    const std::vector<double> gaps = tested_gaps(width, room);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        const double x = corner.x + static_cast<double>(i) * column;
        for (int k = 0; k < kAlike; ++k)
            for (const double below : {0.0, width + gaps[i]})
                drawn.dot({x + width / 2 + k * pair_step, y + below});
        drawn.text(fmt::format("{:g}", gaps[i]), {x, y + 2 * width + gaps.back() + letter / 3}, letter);
    }
    y += 2 * width + gaps.back() + letter / 3 + 2 * letter;

    const double step = room / kTones.size();
    for (std::size_t i = 0; i < kTones.size(); ++i) {
        const glm::dvec2 place(corner.x + static_cast<double>(i) * step, y);
        draw_tone(drawn, place, patch, dot_width_mm(pen), kTones[i]);
        drawn.text(fmt::format("{}", kTones[i]), place + glm::dvec2(patch + width + letter / 3, 0), letter);
    }
    return y + patch - corner.y;
}

void check_pen(const Pen& pen) {
    if (!(pen.width_mm > 0))
        throw failure(
            "{} has no width, which its dots are compared with; give one, as in cmyk:0.3 or Sky:#3aa0d8:0.3",
            pen.name);
    if (pen.width_mm < kFinestTestedMm)
        throw failure(
            "{} is {:g} mm wide, and a test sheet would have millions of its dots; give the width of a real "
            "pen, {:g} mm or more",
            pen.name, pen.width_mm, kFinestTestedMm);
    if (pen.width_mm > kWidestTestedMm)
        throw failure("{} is {:g} mm wide; a test sheet has room for up to {:g} mm", pen.name, pen.width_mm,
                      kWidestTestedMm);
}

}  // namespace

TestSheet test_sheet(std::span<const Pen> pens, const PageSize& page) {
    for (const Pen& pen : pens) check_pen(pen);
    const double room = page.width_mm - 2 * kBorderMm;
    constexpr double kLeastRoomMm = 150, kHeaderMm = 2, kHeadedMm = 6, kBetweenMm = 3;
    if (room < kLeastRoomMm)
        throw failure("a test sheet is {:g} mm wide, and the page is {:g}; give a4 or a larger page",
                      kLeastRoomMm + 2 * kBorderMm, page.width_mm);
    TestSheet sheet;
    glm::dvec2 corner(kBorderMm, kBorderMm + kHeadedMm);
    for (std::size_t i = 0; i < pens.size(); ++i) {
        const int pen = static_cast<int>(i);
        const double high = draw_block(Drawn(sheet, pen), pens[i], pen + 1, corner, room);
        corner.y += high + std::max(kBetweenMm, 4 * pens[i].width_mm);
    }
    // By the last pen, the darkest, so that a light one's sheet can be read too.
    add_text(sheet.strokes, "dapple test sheet - gaps of pairs in mm - tones in per cent",
             {kBorderMm, kBorderMm}, kHeaderMm, static_cast<int>(pens.size()) - 1);
    double lowest = 0;
    for (const glm::dvec2 point : sheet.strokes.points) lowest = std::max(lowest, point.y);
    if (lowest > page.height_mm - kBorderMm / 2)
        throw failure(
            "the test sheet of these pens is {:.0f} mm high, and the page is {:g}; give fewer pens, or a "
            "larger page",
            lowest + kBorderMm / 2, page.height_mm);
    return sheet;
}

}  // namespace dapple
