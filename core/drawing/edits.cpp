#include "core/drawing/edits.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/drawing/settings.h"
#include "core/failure.h"
#include "core/text/number_words.h"

namespace dapple {

namespace {

constexpr std::size_t kRows = 256, kMostPoints = 100'000;

// The text up to the separator, which goes with it.
std::string_view cut_off(std::string_view& text, char separator) {
    const std::string_view first = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(first.size() + 1, text.size()));
    return first;
}

float number_in(std::string_view text, double least, double most) {
    const auto number = number_of<float>(text);
    if (!number || !(*number >= static_cast<float>(least) && *number <= most))
        throw failure("'{}' is no number from {:g} to {:g}", text.substr(0, 20), least, most);
    return *number;
}

Edit parse_edit(std::string_view text) {
    using Kind = Edit::Kind;
    const auto kind = value_named<Kind>(cut_off(text, ' '));
    if (!kind) throw failure("it has to begin with bare or dot");
    Edit edit{.kind = *kind};
    while (!text.empty()) {
        std::string_view word = cut_off(text, ' ');
        if (word.starts_with('r')) {
            edit.radius_mm = number_in(word.substr(1), kSmallestRadiusMm, kLargestRadiusMm);
        } else if (word.starts_with('p') && kind == Kind::dot) {
            edit.pen = number_of<int>(word.substr(1)).value_or(0) - 1;
            if (edit.pen < 0 || edit.pen >= int{kMostPens}) throw failure("'{}' is no pen, p1 to p12", word);
        } else {
            const float x = number_in(cut_off(word, ','), -kLongestSideMm, kLongestSideMm);
            edit.points.emplace_back(x, number_in(word, -kLongestSideMm, kLongestSideMm));
        }
    }
    const std::size_t points = edit.points.size();
    if (kind == Kind::dot && points != 1) throw failure("a dot has one place, as in 'dot 10,20'");
    if (points < (kind == Kind::dot || edit.radius_mm > 0 ? 1 : 3))
        throw failure("it needs three places or more, or a radius, as in 'bare r2 10,20'");
    return edit;
}

bool covers(const Edit& edit, glm::dvec2 at) {
    bool inside = false;
    const std::size_t points = edit.points.size();
    for (std::size_t i = 0; i < points; ++i) {
        const glm::dvec2 from = edit.points[(i + points - 1) % points], to = edit.points[i];
        const glm::dvec2 way = to - from, to_here = at - from;
        if (edit.radius_mm == 0) {  // how often a line to the left goes out of it
            if ((from.y <= at.y) != (to.y <= at.y)) inside ^= to_here.y / way.y * way.x < to_here.x;
        } else if (i > 0 || points == 1) {
            const double square = std::max(glm::dot(way, way), 1e-300);
            const double along = std::clamp(glm::dot(to_here, way) / square, 0.0, 1.0);
            inside |= glm::length(to_here - along * way) <= edit.radius_mm;
        }
    }
    return inside;
}

}  // namespace

std::vector<Edit> parse_edits(std::string_view text) {
    std::vector<Edit> edits;
    std::size_t points = 0;
    while (!text.empty()) {
        const std::string_view one = cut_off(text, ';');
        try {
            edits.push_back(parse_edit(one));
        } catch (const std::runtime_error& error) {
            throw failure("edit {}, '{}': {}", edits.size() + 1, one.substr(0, 40), error.what());
        }
        points += edits.back().points.size();
        if (points > kMostPoints) throw failure("the edits have more than {} points", grouped(kMostPoints));
    }
    return edits;
}

std::string text_of(const Edit& edit) {
    std::string text(name_of(edit.kind));
    if (edit.radius_mm > 0) text += fmt::format(" r{}", edit.radius_mm);
    if (edit.pen > 0) text += fmt::format(" p{}", edit.pen + 1);
    for (const glm::vec2 point : edit.points) text += fmt::format(" {},{}", point.x, point.y);
    return text + ";";
}

IsBare bare_places(const std::vector<Edit>& edits, const PageLayout& layout) {
    std::vector<std::vector<std::size_t>> rows(kRows);  // of the page: which edits reach into each
    const auto row_of = [height = layout.page.height_mm](double y_mm) {
        return static_cast<std::size_t>(std::clamp(y_mm / height, 0.0, 1.0) * (kRows - 1));
    };
    for (std::size_t i = 0; i < edits.size(); ++i) {
        if (edits[i].kind == Edit::Kind::dot) continue;
        const auto [first, last] = std::minmax_element(edits[i].points.begin(), edits[i].points.end(),
                                                       [](glm::vec2 a, glm::vec2 b) { return a.y < b.y; });
        const double reach = edits[i].radius_mm;
        for (std::size_t row = row_of(first->y - reach); row <= row_of(last->y + reach); ++row)
            rows[row].push_back(i);
    }
    return [&edits, layout, row_of, rows = std::move(rows)](glm::dvec2 place, std::size_t since) {
        const glm::dvec2 at = layout.picture.low + place * layout.page.mm_per_page_unit;
        const auto& row = rows[row_of(at.y)];
        return std::any_of(row.begin(), row.end(),
                           [&](std::size_t i) { return i >= since && covers(edits[i], at); });
    };
}

void apply(const std::vector<Edit>& edits, const PageLayout& layout, double scale, bool by_pen,
           bool thresholds, DotPieces& dots, const std::function<void()>& give_sizes) {
    const IsBare is_bare = bare_places(edits, layout);
    const double unit = layout.page.mm_per_page_unit;
    for (Dots& piece : dots.pieces)
        leave(piece, [&](std::size_t i) { return !is_bare({piece.x[i], piece.y[i]}, 0); });
    if (dots.pieces.empty()) dots.pieces.emplace_back();
    const auto piece_of = [&](const Edit& edit) -> Dots& {
        const std::size_t last = dots.pieces.size() - 1;
        return dots.pieces[by_pen ? std::min(static_cast<std::size_t>(edit.pen), last) : last];
    };
    std::vector<std::pair<const Edit*, std::size_t>> own;  // with radii of their own, and where they are
    for (std::size_t i = 0; i < edits.size(); ++i) {
        if (edits[i].kind != Edit::Kind::dot) continue;
        const glm::dvec2 at(edits[i].points[0]), place = (at - layout.picture.low) / unit;
        const bool on_page =
            std::min(at.x, at.y) >= 0 && at.x <= layout.page.width_mm && at.y <= layout.page.height_mm;
        if (!on_page || is_bare(place, i)) continue;
        Dots& piece = piece_of(edits[i]);
        if (edits[i].radius_mm > 0) own.emplace_back(&edits[i], piece.size());
        piece.x.push_back(static_cast<float>(place.x));
        piece.y.push_back(static_cast<float>(place.y));
    }
    for (Dots& piece : dots.pieces) {
        if (thresholds || !piece.threshold.empty()) piece.threshold.resize(piece.size(), 0);
        if (thresholds || !piece.critical.empty()) piece.critical.resize(piece.size(), float(scale));
    }
    give_sizes();
    for (const auto& [edit, index] : own)
        if (FloatBuffer& radius = piece_of(*edit).radius; !radius.empty())
            radius[index] = static_cast<float>(edit->radius_mm / unit);
}

std::uint64_t duplicates_among(const DotPieces& dots) {
    std::vector<std::pair<float, float>> places;
    for_each_position(dots, [&](float x, float y) { places.emplace_back(x, y); });
    std::sort(places.begin(), places.end());
    return static_cast<std::uint64_t>(places.end() - std::unique(places.begin(), places.end()));
}

}  // namespace dapple
