#include "lab/analysis/drawing_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "core/text/number_words.h"

namespace dapple {
namespace {

constexpr double kRounded = 0.01;  // mm that a written place may lie beyond the page

[[noreturn]] void not_ours(const std::string& name, const char* kind) {
    throw std::runtime_error(fmt::format(
        "{}: is not {} that dapple render wrote; for other points give a table (.csv)", name, kind));
}

PlacedPoints on_page(PlacedPoints placed, const std::string& name) {
    if (placed.points.empty()) throw std::runtime_error(name + ": has no dots");
    const glm::dvec2 page(placed.domain.width, placed.domain.height);
    for (glm::dvec2& p : placed.points) {
        const glm::dvec2 inside(std::clamp(p.x, 0.0, page.x), std::clamp(p.y, 0.0, page.y));
        if (std::max(std::abs(p.x - inside.x), std::abs(p.y - inside.y)) > kRounded)
            throw std::runtime_error(
                fmt::format("{}: has a dot at {:g}, {:g} mm, outside its page", name, p.x, p.y));
        p = inside;
    }
    return placed;
}

// The number between the quotes after `key="`, of the text up to `unit`.
std::optional<double> attribute(std::string_view element, std::string_view key, std::string_view unit = "") {
    const std::string begin = fmt::format(" {}=\"", key);
    const std::size_t at = element.find(begin);
    if (at == element.npos) return {};
    const std::string_view rest = element.substr(at + begin.size());
    const std::string_view value = rest.substr(0, rest.find('"'));
    if (!value.ends_with(unit)) return {};
    return number_of<double>(value.substr(0, value.size() - unit.size()));
}

// From `begin` to the next '>'; empty if there is none.
std::string_view element_at(std::string_view text, std::size_t begin) {
    const std::size_t end = begin == text.npos ? text.npos : text.find('>', begin);
    return end == text.npos ? std::string_view{} : text.substr(begin, end - begin);
}

}  // namespace

PlacedPoints points_of_json(std::string_view text, const std::string& name) {
    constexpr const char* kKind = "a drawing in JSON";
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    PlacedPoints placed{.domain = {.topology = Topology::window}, .points = {}};
    try {
        placed.domain.width = json.at("page").at("width_mm").get<double>();
        placed.domain.height = json.at("page").at("height_mm").get<double>();
        const auto& columns = json.at("columns");
        const auto column_of = [&](const char* column) {
            const auto found = std::find(columns.begin(), columns.end(), column);
            if (found == columns.end()) not_ours(name, kKind);
            return std::size_t(found - columns.begin());
        };
        const std::size_t x = column_of("x_mm"), y = column_of("y_mm");
        for (const auto& dot : json.at("dots"))
            placed.points.emplace_back(dot.at(x).get<double>(), dot.at(y).get<double>());
    } catch (const nlohmann::json::exception&) {
        not_ours(name, kKind);
    }
    if (!(placed.domain.width > 0 && placed.domain.height > 0)) not_ours(name, kKind);
    return on_page(std::move(placed), name);
}

PlacedPoints points_of_svg(std::string_view text, const std::string& name) {
    constexpr const char* kKind = "an SVG";
    const std::string_view root = element_at(text, text.find("<svg "));
    const std::optional<double> width = attribute(root, "width", "mm"),
                                height = attribute(root, "height", "mm");
    if (!width || !height || !(*width > 0 && *height > 0) || root.find(" viewBox=\"0 0 ") == root.npos)
        not_ours(name, kKind);
    constexpr double kMmPerPx = kMmPerInch / 96;
    PlacedPoints placed{.domain = {*width, *height, Topology::window}, .points = {}};
    for (std::size_t at = text.find("<circle "); at != text.npos; at = text.find("<circle ", at + 1)) {
        const std::string_view circle = element_at(text, at);
        const std::optional<double> x = attribute(circle, "cx"), y = attribute(circle, "cy");
        if (!x || !y || circle.find(" transform=") != circle.npos) not_ours(name, kKind);
        placed.points.push_back(glm::dvec2(*x, *y) * kMmPerPx);
    }
    if (placed.points.empty() && text.find("<path ") != text.npos)
        throw std::runtime_error(
            name + ": is drawn with strokes, which do not say where the dots are; save it as .json or .csv");
    return on_page(std::move(placed), name);
}

}  // namespace dapple
