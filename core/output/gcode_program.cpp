#include "core/output/gcode_program.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/text/numbers.h"

namespace dapple {
namespace {

using Part = double PlottingTime::*;
using To = MachineStep::To;
using PieceKind = GcodePiece::Kind;

constexpr double kPlaceGridMm = 0.001;  // places have three decimals

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
    Reader(GcodeProgram& result, const GcodeStyle& style, GcodeTool tool)
        : result_(result), style_(style), tool_(tool) {}

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
                text += gcode_text(piece, style_);
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
};

}  // namespace

GcodeProgram program_of(const GcodeStyle& style, GcodeTool tool, double acceleration, const PageSize& page) {
    GcodeProgram result;
    const GcodeTemplate& lines = style.lines;
    // The whole template first: M280 anywhere tells whose it is.
    for (const auto& each : {lines.start, lines.each_dot, lines.down, lines.up}) {
        for (const GcodePiece& piece : each) result.is_marlin |= piece.text.find("M280") != piece.text.npos;
    }
    Reader reader(result, style, tool);
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
               .page_height_mm = page.height_mm,
               .registration = {style.registration.begin(), style.registration.end()},
               .several_pens = style.pens.size() > 1};
    constexpr double kPlaceBytes = 7;  // 123.456
    for (const GcodePiece& piece : lines.line)
        result.line_bytes += piece.kind == PieceKind::text ? static_cast<double>(piece.text.size())
                             : piece.kind == PieceKind::x || piece.kind == PieceKind::y
                                 ? kPlaceBytes
                                 : static_cast<double>(gcode_text(piece, style).size());
    return result;
}

}  // namespace dapple
