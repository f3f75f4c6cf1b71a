#pragma once
// Machines that read what is written for them, and note where a dot comes onto the paper. Written from the
// languages' definitions, for tests, with nothing of the writers in them.

#include <algorithm>
#include <glm/vec2.hpp>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dapple {

/// What a plotter did, millimetres from the lower left corner.
struct Plotted {
    std::vector<glm::dvec2> dots{};
    glm::dvec2 at{0, 0};
    std::vector<std::vector<glm::dvec2>> lines{};  // where it moved with its tool down
    struct Change {
        std::string pen{};  // what the person is told; of HPGL, the number
        std::size_t first_dot = 0;
    };
    std::vector<Change> changes{};   // of pens, where the machine waits
    std::vector<double> bursts_s{};  // how long each dot was burned for that M4 made
};

/// Whether the tool may move while it is down.
enum class Lines { refused, drawn };

/// A machine with a Z axis, or a servo or a laser that M3 drives at over S50. It makes a dot where it rests
/// with its tool down, or in the middle of a way of less than 0.1 mm along which M4 has the laser on. Throws
/// std::runtime_error if the tool moves while it is down, if anything moves before millimetres and places are
/// agreed on, or at a word that such machines don't know.
inline Plotted plotted_gcode(const std::string& text, Lines may = Lines::refused) {
    Plotted plot;
    bool millimetres = false, places = false, on = false, moving = false, goes_on = false;
    double power = 0, z = 1, feed = 0;
    int motion = -1;
    const auto is_down = [&] { return z <= 0 || (on && power > 50); };
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        line.erase(std::min(line.find(';'), line.size()));  // what follows is a comment
        std::string comment;
        if (const auto open = line.find('('); open != line.npos) {
            const auto close = line.find(')', open);
            comment = line.substr(open + 1, close - open - 1);
            line.erase(open, close - open + 1);
        }
        std::istringstream words(line);
        std::map<char, double> values;
        std::vector<int> g, m;
        for (std::string word; words >> word;) {
            const double value = std::stod(word.substr(1));
            if (word[0] == 'G')
                g.push_back(static_cast<int>(value));
            else if (word[0] == 'M')
                m.push_back(static_cast<int>(value));
            else
                values[word[0]] = value;
        }
        if (values.contains('F')) feed = values['F'];
        if (values.contains('S')) power = values['S'];
        for (const int code : m) {
            if (code == 0) {
                if (is_down()) throw std::runtime_error("waits with its tool down: " + line);
                plot.changes.push_back({comment, plot.dots.size()});
                continue;
            }
            if (code < 2 || code > 5) throw std::runtime_error("unknown: " + line);
            on = code == 3 || (on && code == 2);
            moving = code == 4 || (moving && code == 2);  // its beam is on while it moves
        }
        bool rests = false;
        for (const int code : g) {
            if (code == 21)
                millimetres = true;
            else if (code == 90 || code == 91)
                places = code == 90;
            else if (code == 0 || code == 1)
                motion = code;
            else if (code == 4)
                rests = true;
            else if (code != 94)
                throw std::runtime_error("unknown: " + line);
        }
        if (rests) {
            if (!(values.at('P') > 0)) throw std::runtime_error("no rest: " + line);
            if (is_down()) plot.dots.push_back(plot.at);
            continue;
        }
        if (values.contains('Z')) z = values['Z'];
        if (!values.contains('X') && !values.contains('Y')) continue;
        if (moving) {
            const double way = values['X'];
            if (places || motion != 1 || values.contains('Y') || !(way > 0 && way < 0.1) || feed <= 0)
                throw std::runtime_error("must not burn: " + line);
            plot.dots.push_back(plot.at + glm::dvec2(way / 2, 0));
            plot.bursts_s.push_back(60 * way / feed);
            plot.at.x += way;
            continue;
        }
        const bool draws = is_down() && may == Lines::drawn && motion == 1;
        if (draws && (plot.lines.empty() || !goes_on)) plot.lines.push_back({plot.at});
        goes_on = draws;
        if (!millimetres || !places || (is_down() && !draws) || (motion == 1 && feed <= 0) || motion < 0)
            throw std::runtime_error("must not move: " + line);
        if (values.contains('X')) plot.at.x = values['X'];
        if (values.contains('Y')) plot.at.y = values['Y'];
        if (draws) plot.lines.back().push_back(plot.at);
    }
    if (is_down() || moving) throw std::runtime_error("the tool stays down");
    return plot;
}

/// A pen plotter, 40 units to the millimetre. It makes a dot where the pen goes down without a place, while a
/// line of no length is left out, as hp2xx does. Throws std::runtime_error if the pen is then moved, before
/// there is one, or at an unknown instruction.
inline Plotted plotted_hpgl(const std::string& text, Lines may = Lines::refused) {
    Plotted plot;
    bool down = false, ready = false, goes_on = false;
    int pen = 0;
    std::istringstream instructions(text);
    for (std::string each; std::getline(instructions >> std::ws, each, ';');) {
        const std::string name = each.substr(0, 2), rest = each.substr(2);
        if (name == "IN") {
            ready = true;
        } else if (name == "CO") {
            if (ready || !rest.starts_with(" \"") || !rest.ends_with('"'))
                throw std::runtime_error("no comment before all others: " + each);
        } else if (name == "SP") {
            pen = std::stoi(rest);
            if (pen > 0) plot.changes.push_back({rest, plot.dots.size()});
        } else if (name == "PU" || name == "PD") {
            const bool was_down = std::exchange(down, name == "PD");
            if (!down) goes_on = false;
            if (!ready || (down && pen == 0)) throw std::runtime_error("no pen: " + each);
            if (down && !was_down && rest.empty()) plot.dots.push_back(plot.at);
            std::istringstream numbers(rest);
            int x = 0, y = 0;
            char comma = 0;
            while (numbers >> x >> comma >> y) {
                const glm::dvec2 to(x / 40.0, y / 40.0);
                if (down && to != plot.at) {
                    if (may == Lines::refused) throw std::runtime_error("a line: " + each);
                    if (!goes_on) plot.lines.push_back({plot.at});
                    goes_on = true;
                    plot.lines.back().push_back(to);
                }
                plot.at = to;
                numbers >> comma;
            }
        } else {
            throw std::runtime_error("unknown: " + each);
        }
    }
    if (down || pen != 0) throw std::runtime_error("the pen stays");
    return plot;
}

}  // namespace dapple
