#include "io/decoding/radiance_header.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <locale>
#include <optional>
#include <sstream>
#include <string_view>

#include "io/decoding/decoded_image.h"

namespace dapple {
namespace {

// The numbers of a line after its "="; those that are not there are 0.
glm::dvec3 numbers_in(std::string_view line) {
    std::istringstream numbers(std::string(line.substr(line.find('=') + 1)));
    numbers.imbue(std::locale::classic());
    glm::dvec3 read(0);
    numbers >> read.x >> read.y >> read.z;
    return read;
}

// "-Y 480 +X 640": rows from the top down, each from left to right. The axis that comes first is that across
// the stored rows.
struct Order {
    std::string_view first, second;
    int orientation;
    bool of_columns() const { return first[1] == 'X'; }
};
constexpr std::array<Order, 8> kOrders{{{"-Y", "+X", 1},
                                        {"-Y", "-X", 2},
                                        {"+Y", "-X", 3},
                                        {"+Y", "+X", 4},
                                        {"+X", "-Y", 5},
                                        {"-X", "-Y", 6},
                                        {"-X", "+Y", 7},
                                        {"+X", "+Y", 8}}};

}  // namespace

RadianceHeader radiance_header(int file) {
    std::array<char, 1 << 16> beginning{};
    const ssize_t got = ::pread(file, beginning.data(), beginning.size(), 0);
    std::string_view rest(beginning.data(), got < 0 ? 0 : static_cast<std::size_t>(got));
    const auto take_line = [&rest]() -> std::optional<std::string_view> {
        const std::size_t end = rest.find('\n');
        if (end == rest.npos) return std::nullopt;
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    };
    RadianceHeader header{.plain = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"};
    glm::dvec3 multiplied(1);
    double height_for_width = 1;
    for (;;) {
        const auto line = take_line();
        if (!line) throw DecodeError("the picture is damaged (its header has no end)");
        if (line->empty()) break;
        if (line->starts_with("FORMAT=32-bit_rle_xyze"))
            throw DecodeError(
                "has colours as XYZ, which cannot be read here; Radiance's ra_xyze -r makes them red, green "
                "and "
                "blue");
        if (line->starts_with("FORMAT=") && line->find("32-bit_rle_rgbe") == line->npos)
            throw DecodeError("has pixels of a format that is not Radiance's: " +
                              std::string(line->substr(7)));
        if (line->starts_with("EXPOSURE=")) multiplied *= numbers_in(*line).x;
        if (line->starts_with("COLORCORR=")) multiplied *= numbers_in(*line);
        if (line->starts_with("PIXASPECT=")) height_for_width *= numbers_in(*line).x;
        if (line->starts_with("GAMMA=")) header.plain += std::string(*line) + '\n';
    }
    const glm::dvec3 light = 1.0 / multiplied;
    for (int i = 0; i < 3; ++i) {
        if (!(light[i] > 0 && light[i] <= kMostLightOfAPixel))
            throw DecodeError(
                "says in its header by which EXPOSURE or COLORCORR its light was multiplied, and that is not "
                "a number over 0; mend these lines or leave them out");
        header.light[i][i] = static_cast<float>(light[i]);
    }
    std::istringstream size(std::string(take_line().value_or("")));
    std::string first, second;
    long rows = 0, columns = 0;
    size >> first >> rows >> second >> columns;
    const auto order = std::ranges::find_if(
        kOrders, [&](const Order& known) { return known.first == first && known.second == second; });
    if (order == kOrders.end() || rows <= 0 || columns <= 0)
        throw DecodeError("the picture is damaged (its header has no size such as -Y 480 +X 640)");
    header.orientation = order->orientation;
    // Where a row is upright in the picture, its pixels lie on their sides.
    header.pixel_aspect = static_cast<float>(order->of_columns() ? height_for_width : 1 / height_for_width);
    header.plain += "\n-Y " + std::to_string(rows) + " +X " + std::to_string(columns) + '\n';
    header.size = static_cast<std::size_t>(got) - rest.size();
    return header;
}

}  // namespace dapple
