#include "io/reports/tile_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "core/text/number_words.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

// Everything in px of 96 to the inch.
constexpr double kWidth = 760;
constexpr double kHeight = 500;
constexpr double kMargin = 30;
constexpr double kGap = 26;
constexpr double kLargeSide = 216;
constexpr double kSmallSide = 155.5;
constexpr double kUpperRow = 54;  // of the upper row
constexpr double kCaption = 38;
constexpr std::size_t kMostNumbers = 64;
constexpr std::size_t kMostCircled = 256;  // smaller circles cannot be told from the points

constexpr std::string_view kInkColour = "#1d1d1f";
constexpr std::string_view kQuietColour = "#6e6e73";
constexpr std::array<std::string_view, 4> kQuadrantColours{"#0b6fb8", "#d1570b", "#0a8a63", "#8a4fb0"};

struct Panel {
    double x = 0, y = 0, side = 0;
    glm::dvec2 at(glm::dvec2 p) const { return glm::dvec2(x, y) + side * p; }
};

// Spacing of n points in a panel, in px, and the radius of a dot that looks right at it.
double spacing(const Panel& panel, std::size_t count) {
    return panel.side / std::sqrt(static_cast<double>(count));
}
double dot_radius(const Panel& panel, std::size_t count) {
    return std::min(0.22 * spacing(panel, count), 0.016 * panel.side);
}

class Figure {
 public:
    Figure(std::ostream& out, const StoredTile& stored) : text_(out), stored_(stored) {
        for (const BinaryPoint p : points_of(0)) points_.push_back(to_unit_square(p));
    }

    void write() {
        begin();
        const auto large = [](int column) {
            return Panel{kMargin + column * (kLargeSide + kGap), kUpperRow, kLargeSide};
        };
        write_tile(large(0));
        write_copies(large(1));
        write_ranks(large(2));
        for (int k = 0; k < 4; ++k) {
            const Panel panel{kMargin + k * (kSmallSide + kGap), kUpperRow + kLargeSide + kCaption,
                              kSmallSide};
            write_first(panel, k + 1);
        }
        text_ << "</svg>\n";
        text_.flush();
    }

 private:
    void begin();
    void write_tile(const Panel& panel);
    void write_copies(const Panel& panel);
    void write_ranks(const Panel& panel);
    void write_first(const Panel& panel, int quarters);

    void frame(const Panel& panel, bool quadrants);
    void letter_f(const Panel& panel, glm::dvec2 centre, double size, Orientation g, std::string_view colour);
    void caption(const Panel& panel, std::string_view words);
    void circle(glm::dvec2 centre, double radius);
    void number(double value) { text_.fixed(value, 2); }
    template <class... Values>
    void line(fmt::format_string<Values...> format, Values&&... values) {
        text_ << fmt::format(format, std::forward<Values>(values)...) << '\n';
    }
    std::size_t size() const { return stored_.tile.size(); }
    std::span<const BinaryPoint> points_of(std::size_t kind) const {
        return std::span(stored_.tile.points).subspan(kind * size(), size());
    }
    int rank_of(std::size_t i) const { return static_cast<int>(stored_.ranking.tile[i]); }

    TextBuffer text_;
    const StoredTile& stored_;
    std::vector<glm::dvec2> points_;  // of kind 0
};

void Figure::begin() {
    const auto mm = [](double px) { return px * kMmPerInch / 96; };
    text_ << fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{0:.3f}mm" height="{1:.3f}mm" viewBox="0 0 {2} {3}" font-family="sans-serif">
<rect width="{2}" height="{3}" fill="#ffffff"/>
<text x="{4}" y="32" font-size="15" fill="{5}">{6}</text>
)",
        mm(kWidth), mm(kHeight), kWidth, kHeight, kMargin, kInkColour, headline(stored_.tile));
}

void Figure::circle(glm::dvec2 centre, double radius) {
    text_ << R"(<circle cx=")";
    number(centre.x);
    text_ << R"(" cy=")";
    number(centre.y);
    text_ << R"(" r=")";
    number(std::max(radius, 0.05));
    text_ << "\"/>\n";
}

void Figure::frame(const Panel& panel, bool quadrants) {
    const double half = panel.side / 2;
    line(R"(<rect x="{}" y="{}" width="{}" height="{}" fill="none" stroke="{}" stroke-width="1"/>)", panel.x,
         panel.y, panel.side, panel.side, kInkColour);
    if (!quadrants) return;
    line(R"(<path d="M{} {}v{}M{} {}h{}" stroke="{}" stroke-width="0.7" stroke-dasharray="3 2.5"/>)",
         panel.x + half, panel.y, panel.side, panel.x, panel.y + half, panel.side, kQuietColour);
}

// An upright F when g is the identity; size is its height.
void Figure::letter_f(const Panel& panel, glm::dvec2 centre, double size, Orientation g,
                      std::string_view colour) {
    constexpr std::array<glm::dvec2, 10> outline{{{-0.29, -0.5},
                                                  {0.33, -0.5},
                                                  {0.33, -0.32},
                                                  {-0.09, -0.32},
                                                  {-0.09, -0.1},
                                                  {0.22, -0.1},
                                                  {0.22, 0.08},
                                                  {-0.09, 0.08},
                                                  {-0.09, 0.5},
                                                  {-0.29, 0.5}}};
    text_ << R"(<path d=")";
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 p = panel.at(centre + size * apply(g, outline[i]));
        text_ << (i == 0 ? 'M' : 'L');
        number(p.x);
        text_ << ' ';
        number(p.y);
    }
    text_ << R"(Z" fill=")" << colour << R"(" fill-opacity="0.13"/>)" << '\n';
}

void Figure::caption(const Panel& panel, std::string_view words) {
    line(R"(<text x="{}" y="{}" font-size="11.5" fill="{}">{}</text>)", panel.x, panel.y + panel.side + 17,
         kQuietColour, words);
}

void Figure::write_tile(const Panel& panel) {
    letter_f(panel, {0.5, 0.5}, 0.62, Orientation{0}, kInkColour);
    text_ << R"(<g id="tile" fill=")" << kInkColour << "\">\n";
    for (const glm::dvec2 p : points_) circle(panel.at(p), dot_radius(panel, size()));
    text_ << "</g>\n";
    frame(panel, false);
    caption(panel, stored_.tile.kinds() > 1 ? "kind 0" : "the tile");
}

void Figure::write_copies(const Panel& panel) {
    const double radius = dot_radius(panel, 4 * size());
    for (int q = 0; q < 4; ++q) {
        const glm::dvec2 centre(0.25 + 0.5 * (q & 1), 0.25 + 0.5 * (q >> 1));
        letter_f(panel, centre, 0.31, stored_.tile.rule.child[q], kQuadrantColours[q]);
    }
    frame(panel, true);
    text_ << "<g id=\"copies\">\n";
    for (int q = 0; q < 4; ++q) {
        text_ << R"(<g fill=")" << kQuadrantColours[q] << "\">\n";
        for (const BinaryPoint p : points_of(stored_.tile.next_kind[0][q])) {
            const BinaryPoint turned = apply(stored_.tile.rule.child[q], p);
            circle(panel.at(to_unit_square(shrink_to_quadrant(q, turned))), radius);
        }
        text_ << "</g>\n";
    }
    const bool circled = size() <= kMostCircled;
    text_ << R"(</g><g id="coinciding" fill=")" << (circled ? "none" : kInkColour);
    if (circled) {
        text_ << R"(" stroke=")" << kInkColour << R"(" stroke-width=")";
        number(std::min(1.0, 0.6 * radius));
    }
    text_ << "\">\n";
    for (const glm::dvec2 p : points_) circle(panel.at(p), (circled ? 2.1 : 1.3) * radius);
    text_ << "</g>\n";
    const std::string copies =
        stored_.tile.kinds() > 1
            ? fmt::format("half-size copies of kinds {}", fmt::join(stored_.tile.next_kind[0], ", "))
            : "half-size copies";
    caption(panel, copies + (circled ? ", own points circled" : ", own points black"));
}

void Figure::write_ranks(const Panel& panel) {
    frame(panel, false);
    const bool numbers = size() <= kMostNumbers;
    if (numbers) {
        const double font = std::min(0.36 * spacing(panel, size()), 16.0);
        line(R"(<g id="ranks" fill="{}" font-size="{:.2f}" text-anchor="middle">)", kInkColour, font);
        for (std::size_t i = 0; i < size(); ++i) {
            const glm::dvec2 p = panel.at(points_[i]);
            text_ << R"(<text x=")";
            number(p.x);
            text_ << R"(" y=")";
            number(p.y + 0.36 * font);  // the middle of the digits
            text_ << "\">" << std::int64_t{rank_of(i)} << "</text>\n";
        }
    } else {
        text_ << "<g id=\"ranks\">\n";
        for (std::size_t i = 0; i < size(); ++i) {
            const int grey = 20 + 200 * rank_of(i) / static_cast<int>(size());
            text_ << fmt::format(R"(<g fill="#{0:02x}{0:02x}{0:02x}">)", grey);
            circle(panel.at(points_[i]), 1.6 * dot_radius(panel, size()));
            text_ << "</g>\n";
        }
    }
    text_ << "</g>\n";
    // A tile can be ranked in several ways, of which the paper's is one.
    caption(panel,
            fmt::format("ranks ({}): {}", name_of(stored_.method), numbers ? "0 first" : "dark first"));
}

void Figure::write_first(const Panel& panel, int quarters) {
    const int count = quarters * static_cast<int>(size()) / 4;
    line(R"(<g id="first-{}" fill="{}">)", quarters, kInkColour);
    for (std::size_t i = 0; i < size(); ++i)
        if (rank_of(i) < count) circle(panel.at(points_[i]), dot_radius(panel, size()));
    text_ << "</g>\n";
    frame(panel, false);
    caption(panel, quarters == 4 ? fmt::format("all {} points", count) : fmt::format("the first {}", count));
}

}  // namespace

void write_tile_figure(std::ostream& out, const StoredTile& stored) {
    Figure(out, stored).write();
}

}  // namespace dapple
