#include "core/output/gcode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/output/drawing_format.h"
#include "core/text/number_words.h"
#include "core/text/text_lines.h"

namespace dapple {

namespace {

using Part = double PlottingTime::*;
using To = MachineStep::To;
using PieceKind = GcodePiece::Kind;

constexpr int kGcodeDecimals = 3;
constexpr int kDwellDecimals = 6;  // of seconds: not all machines round them as Grbl does
constexpr double kPlaceGridMm = 0.001;

// `dot`: from the page's lower left corner.
double number_for(PieceKind kind, const GcodeStyle& style, const InkDot& dot) {
    // In the order of PieceKind, whose first is text.
    const std::array numbers{0.0,
                             dot.at.x,
                             dot.at.y,
                             dot.radius_mm,
                             style.feed_mm_per_min,
                             style.dwell_s,
                             burst_feed(style.dwell_s),
                             style.heights.up,
                             style.heights.down,
                             style.laser_power};
    const auto i = static_cast<std::size_t>(kind);
    return i < numbers.size() ? numbers[i] : 0;
}

void write_number(TextBuffer& text, PieceKind kind, const GcodeStyle& style, const InkDot& dot) {
    text.fixed(number_for(kind, style, dot), kind == PieceKind::dwell ? kDwellDecimals : kGcodeDecimals);
}

// What stands in a file for a piece that is of no place and no pen.
std::string piece_text(const GcodePiece& piece, const GcodeStyle& style, double radius_mm) {
    if (piece.kind == PieceKind::text) return piece.text;
    if (piece.kind == PieceKind::pen || piece.kind == PieceKind::name) return "";
    std::ostringstream out;
    TextBuffer text(out);
    write_number(text, piece.kind, style, {.at = {}, .radius_mm = radius_mm});
    text.flush();
    return out.str();
}

// In place of {x} and {y}, which are of the points.
constexpr char kPointX = '\1', kPointY = '\2';

// A letter and what stands after it.
struct Word {
    char letter = 0;
    std::string_view value;
    double number = 0;  // where it is one
};

struct Line {
    MachineStep step;
    bool turns_tool = false, is_marlin = false;
};

class Reader {
 public:
    Reader(GcodeProgram& result, const GcodeStyle& style, GcodeTool tool, double dot_radius_mm)
        : result_(result), style_(style), tool_(tool), dot_radius_mm_(dot_radius_mm) {}

    // `part` is what its moves are counted as; of a dot, whatever each line says.
    MachineSteps steps(std::span<const GcodePiece> pieces, std::optional<Part> part) {
        MachineSteps steps;
        const std::string text = text_of(pieces);
        bool turned = false;
        for (std::string_view rest = text; !rest.empty();) {
            const std::size_t end = rest.find('\n');
            Line line = line_of(rest.substr(0, end));
            line.step.part = part.value_or(part_of(line.step));
            const bool takes_time = line.step.rest_s.value_or(0) > 0 || moves(line.step);
            if (line.turns_tool) {
                if (!part && turned) result_.no_time = true;
                turned = true;
            }
            if (takes_time) turned = false;
            steps.push_back(line.step);
            rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
        }
        return steps;
    }

 private:
    static bool moves(const MachineStep& step) {
        return std::ranges::any_of(step.axes,
                                   [](const MachineStep::Axis& axis) { return axis.to != To::stays; });
    }

    // At a dot.
    Part part_of(const MachineStep& step) const {
        const auto& [x, y, z] = step.axes;
        if (x.to == To::point_x || x.to == To::point_y || y.to == To::point_x || y.to == To::point_y)
            return &PlottingTime::moving_s;
        const bool lifts = step.rest_s ? tool_ == GcodeTool::servo : z.to != To::stays;
        return lifts ? &PlottingTime::lifting_s : &PlottingTime::dots_s;
    }

    std::string text_of(std::span<const GcodePiece> pieces) {
        std::string text;
        for (const GcodePiece& piece : pieces) {
            if (piece.kind == PieceKind::text)
                text += piece.text;
            else if (piece.kind == PieceKind::x)
                text += kPointX;
            else if (piece.kind == PieceKind::y)
                text += kPointY;
            else {
                if (piece.kind == PieceKind::dwell && text.ends_with("G4 P")) result_.p_of_dwell = true;
                text += piece_text(piece, style_, dot_radius_mm_);
            }
        }
        return text;
    }

    Line line_of(std::string_view text) {
        Line line;
        bool rests = false;
        for (Word word; next_word(text, word);) {
            switch (word.letter) {
                case 'G':
                    rests |= word.number == 4;
                    read_g(word, line.step);
                    break;
                case 'M':
                    line.step.rest_s = line.step.rest_s.value_or(0);
                    line.turns_tool |= word.number >= 3 && word.number <= 5;
                    if (word.number == 280) line.turns_tool = line.is_marlin = result_.is_marlin = true;
                    break;
                case 'F':
                    line.step.speed = word.number / 60;
                    break;
                case 'X':
                case 'Y':
                case 'Z': {
                    const To to = word.value == std::string_view(&kPointX, 1)   ? To::point_x
                                  : word.value == std::string_view(&kPointY, 1) ? To::point_y
                                                                                : To::number;
                    line.step.axes[static_cast<std::size_t>(word.letter - 'X')] = {to, word.number};
                    break;
                }
                case 'P':
                    if (rests)
                        line.step.rest_s = result_.is_marlin ? word.number / 1000 : grbl_rest_s(word.number);
                    break;
                case 'S':
                    if (rests) line.step.rest_s = word.number;
                    break;
                default:
                    break;
            }
        }
        return line;
    }

    void read_g(const Word& word, MachineStep& step) {
        const double g = word.number;
        if (g == 0 || g == 1)
            step.rapid = g == 0;
        else if (g == 4)
            step.rest_s = 0;
        else if (g == 90 || g == 91)
            step.relative = g == 91;
        else if (g == 2 || g == 3 || g == 28 || g == 30 || std::floor(g) == 38 || g == 53) {
            const std::string name = "G" + std::string(word.value);
            if (std::ranges::find(result_.uncounted, name) == result_.uncounted.end())
                result_.uncounted.push_back(name);
        }
    }

    // Without comments, in ( ) and from ; on.
    static bool next_word(std::string_view& text, Word& word) {
        while (!text.empty() && text[0] != ';') {
            if (text[0] == '(') {
                text.remove_prefix(std::min(text.find(')'), text.size() - 1) + 1);
                continue;
            }
            const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
            text.remove_prefix(1);
            if (letter < 'A' || letter > 'Z') continue;
            text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
            const auto is_of_value = [](char c) {
                return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == kPointX ||
                       c == kPointY;
            };
            const auto end = std::find_if_not(text.begin(), text.end(), is_of_value) - text.begin();
            const std::string_view value = text.substr(0, static_cast<std::size_t>(end));
            text.remove_prefix(value.size());
            word = {letter, value,
                    number_of<double>(value.starts_with('+') ? value.substr(1) : value).value_or(0)};
            return true;
        }
        return false;
    }

    GcodeProgram& result_;
    const GcodeStyle& style_;
    GcodeTool tool_;
    double dot_radius_mm_;
};

}  // namespace

GcodeProgram program_of(const InkPage& page, GcodeTool tool, double acceleration) {
    GcodeProgram result;
    const GcodeStyle style = page.gcode.value_or(GcodeStyle{});
    const GcodeTemplate& lines = style.lines;
    // The whole template first: M280 anywhere tells whose it is.
    for (const auto& each : {lines.start, lines.each_dot, lines.down, lines.up})
        for (const GcodePiece& piece : each) result.is_marlin |= piece.text.find("M280") != piece.text.npos;
    Reader reader(result, style, tool, page.dot_radius_mm);
    const Part moving = &PlottingTime::moving_s, lifting = &PlottingTime::lifting_s;
    MachineProgram& program = result.program;
    program = {.start = reader.steps(lines.start, moving),
               .end = reader.steps(lines.end, moving),
               .dot = reader.steps(lines.each_dot, std::nullopt),
               .move = reader.steps(lines.move, moving),
               .down = reader.steps(lines.down, lifting),
               .line = reader.steps(lines.line, &PlottingTime::drawing_s),
               .up = reader.steps(lines.up, lifting),
               .pen = reader.steps(lines.pen, moving),
               .top_speed = style.feed_mm_per_min / 60,
               .acceleration = acceleration,
               .drawing_acceleration = acceleration,
               .corner_mm = kGrblCornerMm,
               .look_ahead = kGrblLookAhead,
               .from_origin = true,
               .grid_mm = kPlaceGridMm,
               .page_height_mm = page.size.height_mm,
               .registration = page.registration,
               .several_pens = page.pens.size() > 1};
    constexpr double kPlaceBytes = 7;  // 123.456
    for (const GcodePiece& piece : lines.line)
        result.line_bytes += piece.kind == PieceKind::text ? static_cast<double>(piece.text.size())
                             : piece.kind == PieceKind::x || piece.kind == PieceKind::y
                                 ? kPlaceBytes
                                 : static_cast<double>(piece_text(piece, style, page.dot_radius_mm).size());
    return result;
}

namespace {

// G21: millimetres; G90: places, not steps; G94: the feed in millimetres a minute.
constexpr std::string_view kPenTemplate =
    "start G21\n"
    "start G90\n"
    "start G94\n"
    "start G0 Z{up}\n"
    "move G1 X{x} Y{y} F{feed}\n"
    "dot G1 Z{down} F{feed}\n"
    "dot G4 P{dwell}\n"
    "dot G0 Z{up}\n"
    "down G1 Z{down} F{feed}\n"
    "line G1 X{x} Y{y} F{feed}\n"
    "up G0 Z{up}\n"
    "pen G0 X0 Y0\n"
    "pen M0 ({pen} {name})\n"
    "end G0 X0 Y0\n"
    "end M2\n";

// Grbl turns a servo by the spindle's speed.
constexpr std::string_view kServoTemplate =
    "start G21\n"
    "start G90\n"
    "start G94\n"
    "start M3 S{up}\n"
    "start G4 P{dwell}\n"
    "start G1 F{feed}\n"
    "move G1 X{x} Y{y}\n"
    "dot M3 S{down}\n"
    "dot G4 P{dwell}\n"
    "dot M3 S{up}\n"
    "dot G4 P{dwell}\n"
    "down M3 S{down}\n"
    "down G4 P{dwell}\n"
    "line G1 X{x} Y{y}\n"
    "up M3 S{up}\n"
    "up G4 P{dwell}\n"
    "pen G0 X0 Y0\n"
    "pen M0 ({pen} {name})\n"
    "end G0 X0 Y0\n"
    "end M5\n"
    "end M2\n";

// G1 and no G0 before a burst: Grbl's laser mode burns at G1 only.
constexpr std::string_view kLaserTemplate =
    "start G21\n"
    "start G90\n"
    "start G94\n"
    "start M5\n"
    "start G1 F{feed}\n"
    "move G1 X{x} Y{y}\n"
    "dot M3 S{power}\n"
    "dot G4 P{dwell}\n"
    "dot M5\n"
    "down M3 S{power}\n"
    "line G1 X{x} Y{y}\n"
    "up M5\n"
    "pen G0 X0 Y0\n"
    "pen M0 ({pen} {name})\n"
    "end G0 X0 Y0\n"
    "end M2\n";

// The beam is on between M4 and M5, and moves by kBurstMm. Its feed is no other move's.
static_assert(kBurstMm == 0.05);
constexpr std::string_view kShortBurstTemplate =
    "start G21\n"
    "start G90\n"
    "start G94\n"
    "start M5\n"
    "move G1 X{x} Y{y} F{feed}\n"
    "dot M4 S{power}\n"
    "dot G91 G1 X0.05 F{burn}\n"
    "dot G90\n"
    "dot M5\n"
    "down M3 S{power}\n"
    "line G1 X{x} Y{y} F{feed}\n"
    "up M5\n"
    "pen G0 X0 Y0\n"
    "pen M0 ({pen} {name})\n"
    "end G0 X0 Y0\n"
    "end M2\n";

struct Placeholder {
    std::string_view name;
    PieceKind kind;
};
constexpr std::array kPlaceholders{
    Placeholder{"{x}", PieceKind::x},           Placeholder{"{y}", PieceKind::y},
    Placeholder{"{radius}", PieceKind::radius}, Placeholder{"{feed}", PieceKind::feed},
    Placeholder{"{dwell}", PieceKind::dwell},   Placeholder{"{burn}", PieceKind::burn},
    Placeholder{"{up}", PieceKind::up},         Placeholder{"{down}", PieceKind::down},
    Placeholder{"{power}", PieceKind::power},   Placeholder{"{pen}", PieceKind::pen},
    Placeholder{"{name}", PieceKind::name}};

bool is_of_a_pen(PieceKind kind) {
    return kind == PieceKind::pen || kind == PieceKind::name;
}

bool is_of_a_dot(PieceKind kind) {
    return kind == PieceKind::x || kind == PieceKind::y || kind == PieceKind::radius;
}

void add_gcode_text(std::vector<GcodePiece>& pieces, std::string_view text) {
    if (pieces.empty() || pieces.back().kind != PieceKind::text) pieces.push_back({PieceKind::text});
    pieces.back().text += text;
}

// Whether it has that word, and not one that begins so.
bool has_word(std::string_view line, std::string_view word) {
    line = line.substr(0, line.find_first_of(";("));
    for (std::size_t at = line.find(word); at != line.npos; at = line.find(word, at + 1))
        if (line.substr(at + word.size()).find_first_of("0123456789.") != 0) return true;
    return false;
}

// A line of G-code, its placeholders told from the rest.
void add_gcode_line(std::vector<GcodePiece>& pieces, std::string_view line, const TextLines& at) {
    if (has_word(line, "G20") || has_word(line, "g20"))
        at.fail("G20 says that numbers are inches, but {x} and {y} are millimetres; write G21");
    while (!line.empty()) {
        const std::size_t open = line.find('{');
        add_gcode_text(pieces, line.substr(0, open));
        if (open == line.npos) break;
        line.remove_prefix(open);
        const std::string_view name = line.substr(0, line.find('}') + 1);
        const auto found = std::ranges::find(kPlaceholders, name, &Placeholder::name);
        if (found == kPlaceholders.end()) {
            at.fail(
                fmt::format("\"{}\" is not known; there are {{x}}, {{y}}, {{radius}}, {{feed}}, {{dwell}}, "
                            "{{burn}}, {{up}}, {{down}}, {{power}}, {{pen}} and {{name}}",
                            name.empty() ? line : name));
        }
        pieces.push_back({found->kind});
        line.remove_prefix(name.size());
    }
    add_gcode_text(pieces, "\n");
}

std::string_view without_blanks_before(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text;
}

void check_whole(const GcodeTemplate& lines, const TextLines& at) {
    const auto has_place = [&](std::span<const GcodePiece> pieces) {
        const auto has = [&](PieceKind kind) {
            return std::ranges::find(pieces, kind, &GcodePiece::kind) != pieces.end();
        };
        return has(PieceKind::x) && has(PieceKind::y);
    };
    if (!has_place(lines.each_dot))
        at.fail("the template ends and no line for a dot has {x} and {y}, so the tool would not move");
    const bool any = !lines.down.empty() || !lines.line.empty() || !lines.up.empty();
    if (any && (!has_place(lines.line) || !has_place(lines.move) || lines.down.empty() || lines.up.empty()))
        at.fail(
            "the template ends without all of down, line and up; give all three or none, and {x} and {y} in "
            "line and in move");
    for (const auto& once : {lines.start, lines.end, lines.pen})
        if (std::ranges::any_of(once, [&](const GcodePiece& piece) { return is_of_a_dot(piece.kind); }))
            at.fail("{x}, {y} and {radius} belong to a dot; leave them out of start, pen and end lines");
    for (const auto& other :
         {lines.start, lines.end, lines.each_dot, lines.move, lines.down, lines.line, lines.up})
        if (std::ranges::any_of(other, [&](const GcodePiece& piece) { return is_of_a_pen(piece.kind); }))
            at.fail("{pen} and {name} belong to a pen; use them only in lines that begin with pen");
}

// What stands in a comment, which ( and ) would end.
std::string comment_of(std::string name) {
    std::ranges::replace(name, '(', '[');
    std::ranges::replace(name, ')', ']');
    return name;
}

}  // namespace

GcodeHeights usual_heights(GcodeTool tool) {
    return tool == GcodeTool::servo ? GcodeHeights{20, 90} : GcodeHeights{};
}

double grbl_rest_s(double dwell_s) {
    return std::ceil(dwell_s / kGrblRestStepS - 1e-6) * kGrblRestStepS;
}

bool bursts_move(GcodeTool tool, double dwell_s) {
    return tool == GcodeTool::laser && dwell_s > 0 && dwell_s < kGrblRestStepS;
}

double burst_feed(double dwell_s) {
    constexpr double kLeast = 0.001, kMost = 1e6;  // mm/min that have their digits in a file
    return dwell_s > 0 ? std::clamp(60 * kBurstMm / dwell_s, kLeast, kMost) : kMost;
}

std::string_view gcode_template_of(GcodeTool tool, double dwell_s) {
    switch (tool) {
        case GcodeTool::pen:
            return kPenTemplate;
        case GcodeTool::servo:
            return kServoTemplate;
        case GcodeTool::laser:
            return bursts_move(tool, dwell_s) ? kShortBurstTemplate : kLaserTemplate;
    }
    return "";
}

GcodeTemplate parse_gcode_template(std::string_view text) {
    GcodeTemplate result;
    std::vector<GcodePiece> moves, dots;
    using Section = std::pair<std::string_view, std::vector<GcodePiece>*>;
    const std::array sections{Section{"start", &result.start}, Section{"move", &moves},
                              Section{"dot", &dots},           Section{"down", &result.down},
                              Section{"line", &result.line},   Section{"up", &result.up},
                              Section{"pen", &result.pen},     Section{"end", &result.end}};
    TextLines lines(text);
    while (!lines.at_end()) {
        const std::string_view line = without_blanks_before(lines.next_content());
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        const std::string_view kind = line.substr(0, end), code = without_blanks_before(line.substr(end));
        const auto found = std::ranges::find(sections, kind, &Section::first);
        if (found == sections.end())
            lines.fail(fmt::format(
                "\"{}\" is not known; lines begin with start, move, dot, down, line, up, pen or end", kind));
        add_gcode_line(*found->second, code, lines);
    }
    result.each_dot = result.move = std::move(moves);
    for (GcodePiece& piece : dots) {
        if (piece.kind == PieceKind::text)
            add_gcode_text(result.each_dot, piece.text);
        else
            result.each_dot.push_back(std::move(piece));
    }
    check_whole(result, lines);
    return result;
}

namespace {

class GcodeWriter : public InkWriter {
 public:
    GcodeWriter(std::ostream& out, const InkPage& page)
        : text_(out), page_(page), style_(page.gcode.value_or(GcodeStyle{})) {
        if (page.pens.size() > 1 && lines_.pen.empty())
            throw std::runtime_error(
                "the template for G-code does not say how pens are changed; add a line that begins with pen, "
                "such as pen M0");
        for (const std::string& line : page.comments) text_ << "; " << line << '\n';
        write(lines_.start);
    }

    void begin_pen(int number, const Pen& pen, double width_mm) override {
        pen_ = number;
        pen_name_ = comment_of(pen.name);
        width_mm_ = width_mm;
        if (page_.pens.size() > 1) write(lines_.pen);
    }

    void dot(const InkDot& dot) override { write(lines_.each_dot, dot.at, dot.radius_mm); }

    void stroke(std::span<const glm::dvec2> points) override {
        const double radius_mm = width_mm_ / 2;
        if (points.size() == 1) return write(lines_.each_dot, points[0], radius_mm);
        if (lines_.line.empty())
            throw std::runtime_error(
                "the template for G-code does not say how to draw lines; add lines that begin with down, "
                "line and up");
        write(lines_.move, points[0], radius_mm);
        write(lines_.down, points[0], radius_mm);
        for (const glm::dvec2 p : points.subspan(1)) write(lines_.line, p, radius_mm);
        write(lines_.up, points.back(), radius_mm);
    }

    void end() override {
        write(lines_.end);
        text_.flush();
    }

 private:
    void write(std::span<const GcodePiece> pieces, glm::dvec2 at = {}, double radius_mm = 0) {
        const InkDot dot{.at = {at.x, page_.size.height_mm - at.y}, .radius_mm = radius_mm};
        for (const GcodePiece& piece : pieces) {
            if (piece.kind == PieceKind::text)
                text_ << std::string_view(piece.text);
            else if (piece.kind == PieceKind::pen)
                text_ << std::int64_t{pen_ + 1};
            else if (piece.kind == PieceKind::name)
                text_ << std::string_view(pen_name_);
            else
                write_number(text_, piece.kind, style_, dot);
        }
    }

    TextBuffer text_;
    const InkPage& page_;
    const GcodeStyle style_;
    const GcodeTemplate& lines_ = style_.lines;
    int pen_ = 0;  // that draws
    std::string pen_name_;
    double width_mm_ = 0;
};

}  // namespace

void write_gcode(std::ostream& out, const InkPage& page, const WritingProgress& progress) {
    GcodeWriter writer(out, page);
    write_ink(writer, page, progress);
}

}  // namespace dapple
