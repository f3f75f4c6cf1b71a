#include "core/strokes/strokes.h"

#include <cctype>
#include <glm/common.hpp>
#include <optional>

namespace dapple {

namespace {

constexpr double kHigh = 6, kAdvance = 6, kWide = 4;

std::string_view lines_of(char letter) {
    switch (std::toupper(static_cast<unsigned char>(letter))) {
        // clang-format off
        case 'A': return "0602204246 0444";
        case 'B': return "00063645443303 0030414233";
        case 'C': return "4130100105163645";
        case 'D': return "00062644422000";
        case 'E': return "40000646 0333";
        case 'F': return "400006 0333";
        case 'G': return "41301001051636454323";
        case 'H': return "0006 4046 0343";
        case 'I': return "1030 1636 2026";
        case 'J': return "4045361605";
        case 'K': return "0006 400346";
        case 'L': return "000646";
        case 'M': return "0600234046";
        case 'N': return "06004640";
        case 'O': case '0': return "100105163645413010";
        case 'P': return "06003041423303";
        case 'Q': return "100105163645413010 2446";
        case 'R': return "06003041423303 2346";
        case 'S': return "413010010213334445361605";
        case 'T': return "0040 2026";
        case 'U': return "000516364540";
        case 'V': return "002640";
        case 'W': return "0016233640";
        case 'X': return "0046 4006";
        case 'Y': return "002340 2326";
        case 'Z': return "00400646";
        case '1': return "112026 1636";
        case '2': return "01103041420646";
        case '3': return "0110304142334445361605 1333";
        case '4': return "36300444";
        case '5': return "400002324345361605";
        case '6': return "413010010516364544331304";
        case '7': return "004016";
        case '8': return "13334241301001021304051636454433";
        case '9': return "051636454130100102133342";
        case '.': return "2526";
        case '-': return "1333";
        case '+': return "2125 0343";
        case '(': return "30212536";
        case ')': return "10212516";
        case '_': return "0646";
        default: return "";
            // clang-format on
    }
}

}  // namespace

void add_text(Strokes& strokes, std::string_view text, glm::dvec2 corner, double height_mm, int pen) {
    const double step = height_mm / kHigh;
    for (const char letter : text) {
        std::string_view lines = lines_of(letter);
        while (!lines.empty()) {
            if (lines.front() == ' ') {
                end_stroke(strokes, pen);
                lines.remove_prefix(1);
            }
            strokes.points.push_back(corner + step * glm::dvec2(lines[0] - '0', lines[1] - '0'));
            lines.remove_prefix(2);
        }
        end_stroke(strokes, pen);
        corner.x += step * kAdvance;
    }
}

double text_width_mm(std::string_view text, double height_mm) {
    if (text.empty()) return 0;
    return height_mm / kHigh * (kAdvance * static_cast<double>(text.size() - 1) + kWide);
}

namespace {

// The part of a line that lies in the box, as shares of its length (Liang and Barsky 1984).
struct LinePart {
    double from, to;
};

std::optional<LinePart> part_inside(const Rectangle<double>& box, glm::dvec2 a, glm::dvec2 b) {
    LinePart part{0, 1};
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        const double low = box.low[axis] - a[axis], high = box.high[axis] - a[axis];
        if (way == 0) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        part.from = std::max(part.from, std::min(low / way, high / way));
        part.to = std::min(part.to, std::max(low / way, high / way));
    }
    if (part.from > part.to) return std::nullopt;
    return part;
}

}  // namespace

void end_stroke(Strokes& strokes, int pen) {
    const std::size_t begin = strokes.ends.empty() ? 0 : strokes.ends.back();
    if (strokes.points.size() <= begin) return;
    if (pen != 0 || !strokes.pens.empty()) {
        strokes.pens.resize(strokes.ends.size(), 0);
        strokes.pens.push_back(pen);
    }
    strokes.ends.push_back(strokes.points.size());
}

int pen_of(const Strokes& strokes, std::size_t stroke) {
    return strokes.pens.empty() ? 0 : strokes.pens[stroke];
}

void append(Strokes& to, const Strokes& more) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < more.ends.size(); ++i) {
        to.points.insert(to.points.end(), more.points.begin() + static_cast<std::ptrdiff_t>(begin),
                         more.points.begin() + static_cast<std::ptrdiff_t>(more.ends[i]));
        end_stroke(to, pen_of(more, i));
        begin = more.ends[i];
    }
}

StrokeStream stream_of(const Strokes& strokes, double width_mm) {
    return {.points = strokes.points.size(),
            .width_mm = width_mm,
            .for_each_stroke = [&strokes](const TakeStroke& take) {
                std::size_t begin = 0;
                for (std::size_t i = 0; i < strokes.ends.size(); ++i) {
                    const std::size_t end = strokes.ends[i];
                    take(std::span(strokes.points).subspan(begin, end - begin), pen_of(strokes, i));
                    begin = end;
                }
            }};
}

StrokeStream only(const StrokeStream& stream, int pen) {
    StrokeStream of_pen = stream;
    of_pen.for_each_stroke = [all = stream.for_each_stroke, pen](const TakeStroke& take) {
        all([&](std::span<const glm::dvec2> points, int its_pen) {
            if (its_pen == pen) take(points, its_pen);
        });
    };
    return of_pen;
}

Strokes collected(const StrokeStream& stream) {
    Strokes all;
    stream.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        all.points.insert(all.points.end(), points.begin(), points.end());
        end_stroke(all, pen);
    });
    return all;
}

Strokes cut_to(const Rectangle<double>& box, const StrokeStream& stream) {
    Strokes inside;
    stream.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        if (points.size() == 1 && part_inside(box, points[0], points[0]))
            inside.points.push_back(points[0] - box.low);
        bool goes_on = false;  // the last point is the next line's first
        for (std::size_t i = 1; i < points.size(); ++i) {
            const glm::dvec2 a = points[i - 1], b = points[i];
            const auto part = part_inside(box, a, b);
            if (!goes_on || !part || part->from > 0) end_stroke(inside, pen);
            if (!part) {
                goes_on = false;
                continue;
            }
            const auto at = [&](double share) {
                return glm::clamp(share >= 1 ? b : a + share * (b - a), box.low, box.high) - box.low;
            };
            if (!goes_on || part->from > 0) inside.points.push_back(at(part->from));
            inside.points.push_back(at(part->to));
            goes_on = part->to >= 1;
        }
        end_stroke(inside, pen);
    });
    return inside;
}

}  // namespace dapple
