#include "app/files/volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/files/picture.h"
#include "app/files/text_file.h"
#include "core/text/numbers.h"
#include "core/text/shown_text.h"

namespace dapple {
namespace {

constexpr std::uintmax_t kMostBytes = 4'000'000'000;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
    throw std::runtime_error(fmt::format("{}: {}", printable(file.native()), what));
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

// The next line, without its end; the rest stays. Nothing at the end of the text.
std::optional<std::string_view> take_line(std::string_view& text) {
    if (text.empty()) return std::nullopt;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

// A kind of number in a file.
struct Kind {
    std::size_t bytes;
    double (*read)(const char* bytes);
};
template <class Number>
double read_as(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return static_cast<double>(number);
}
template <class Number>
constexpr Kind kind() {
    return {sizeof(Number), &read_as<Number>};
}

double read_number(const Kind& kind, const char* bytes, bool swapped) {
    std::array<char, 8> there{};
    std::copy_n(bytes, kind.bytes, there.begin());
    if (swapped) std::reverse(there.begin(), there.begin() + static_cast<std::ptrdiff_t>(kind.bytes));
    return kind.read(there.data());
}

// Named as NRRD does; several have other names too.
const std::map<std::string_view, Kind> kNrrdKinds{
    {"uchar", kind<std::uint8_t>()},
    {"uint8", kind<std::uint8_t>()},
    {"uint8_t", kind<std::uint8_t>()},
    {"unsigned char", kind<std::uint8_t>()},
    {"ushort", kind<std::uint16_t>()},
    {"uint16", kind<std::uint16_t>()},
    {"uint16_t", kind<std::uint16_t>()},
    {"unsigned short", kind<std::uint16_t>()},
    {"short", kind<std::int16_t>()},
    {"int16", kind<std::int16_t>()},
    {"float", kind<float>()},
    {"double", kind<double>()},
};
const std::map<std::string_view, Kind> kPlyKinds{
    {"char", kind<std::int8_t>()},     {"int8", kind<std::int8_t>()},     {"uchar", kind<std::uint8_t>()},
    {"uint8", kind<std::uint8_t>()},   {"short", kind<std::int16_t>()},   {"int16", kind<std::int16_t>()},
    {"ushort", kind<std::uint16_t>()}, {"uint16", kind<std::uint16_t>()}, {"int", kind<std::int32_t>()},
    {"int32", kind<std::int32_t>()},   {"uint", kind<std::uint32_t>()},   {"uint32", kind<std::uint32_t>()},
    {"float", kind<float>()},          {"float32", kind<float>()},        {"double", kind<double>()},
    {"float64", kind<double>()},
};

glm::dvec3 finite(const std::filesystem::path& file, const glm::dvec3& point, std::size_t number) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(point[axis])) fail(file, fmt::format("vertex {} is nowhere", number));
    return point;
}

// With the file's name before it.
Volume checked(const std::filesystem::path& file, Volume volume) {
    try {
        check_volume(volume);
    } catch (const std::runtime_error& error) {
        fail(file, error.what());
    }
    return volume;
}

}  // namespace

Volume read_nrrd(const std::filesystem::path& file) {
    const std::string bytes =
        text_of_file(file, {.what = "volume", .most_bytes = kMostBytes, .binary = true});
    std::string_view rest = bytes;
    if (!take_line(rest).value_or("").starts_with("NRRD000"))
        fail(file, "is no NRRD file: it does not begin with NRRD000");
    std::map<std::string, std::string, std::less<>> fields;
    while (true) {
        const auto line = take_line(rest);
        if (!line) fail(file, "ends before its voxels begin");
        if (line->empty()) break;
        const std::size_t colon = line->find(':');
        if (line->starts_with('#') || colon == line->npos) continue;
        fields[std::string(trimmed(line->substr(0, colon)))] = trimmed(line->substr(colon + 1));
    }
    const auto field = [&](const char* name) -> std::string_view {
        const auto there = fields.find(name);
        return there == fields.end() ? std::string_view() : std::string_view(there->second);
    };
    if (!field("data file").empty() || !field("datafile").empty())
        fail(file, "has its voxels in another file; save them in one (.nrrd in place of .nhdr)");
    if (field("encoding") != "raw")
        fail(file, fmt::format("has encoding {}; only raw can be read", field("encoding")));
    const auto kind = kNrrdKinds.find(field("type"));
    if (kind == kNrrdKinds.end())
        fail(file, fmt::format("has voxels of type {}; uchar, ushort, short, float and double can be read",
                               field("type")));
    const std::vector<std::string_view> sizes = words_of(field("sizes"));
    if (field("dimension") != "3" || sizes.size() != 3)
        fail(file, "has not 3 dimensions, with a size for each");
    Volume volume;
    for (int axis = 0; axis < 3; ++axis) {
        const auto size = number_of<int>(sizes[static_cast<std::size_t>(axis)]);
        if (!size || *size < 1 || *size > 100'000)
            fail(file, fmt::format("has a side of {} voxels; 1 to 100,000 can be read",
                                   sizes[static_cast<std::size_t>(axis)]));
        volume.size[axis] = *size;
    }
    const auto spacings = words_of(field("spacings"));
    for (std::size_t axis = 0; axis < 3 && spacings.size() == 3; ++axis)
        if (const auto spacing = number_of<double>(spacings[axis]); spacing && *spacing > 0)
            volume.spacing[static_cast<int>(axis)] = *spacing;
    const double voxels = static_cast<double>(volume.size.x) * volume.size.y * volume.size.z;
    if (voxels * static_cast<double>(kind->second.bytes) > static_cast<double>(rest.size()))
        fail(file, fmt::format("ends too early: {} x {} x {} voxels need {:.0f} bytes, and there are {}",
                               volume.size.x, volume.size.y, volume.size.z,
                               voxels * static_cast<double>(kind->second.bytes), rest.size()));
    const bool swapped = (field("endian") == "big") == (std::endian::native == std::endian::little);
    volume.density.resize(static_cast<std::size_t>(voxels));
    for (std::size_t i = 0; i < volume.density.size(); ++i)
        volume.density[i] =
            static_cast<float>(read_number(kind->second, rest.data() + i * kind->second.bytes, swapped));
    return checked(file, std::move(volume));
}

Volume read_slices(std::span<const std::filesystem::path> pictures, const TellRemark& tell) {
    Volume volume;
    for (const std::filesystem::path& picture : pictures) {
        const Picture read =
            read_picture(picture, PictureLimit::usual, PictureColours::left_out, {}, PictureBehind::black);
        if (tell) tell(picture, read.remark);
        const Grid<float>& light = read.light;
        if (volume.size.z == 0) volume.size = {light.width, light.height, 0};
        if (volume.size.x != light.width || volume.size.y != light.height)
            fail(picture,
                 fmt::format("has {} x {} pixels, and {} has {} x {}; all slices have to be of one size",
                             light.width, light.height, printable(pictures[0].native()), volume.size.x,
                             volume.size.y));
        volume.density.insert(volume.density.end(), light.values.begin(), light.values.end());
        ++volume.size.z;
        if (volume.density.size() > kMostVoxels) break;  // said below
    }
    return checked(pictures[0], std::move(volume));
}

std::vector<glm::dvec3> read_ply(const std::filesystem::path& file) {
    const std::string bytes =
        text_of_file(file, {.what = "point cloud", .most_bytes = kMostBytes, .binary = true});
    std::string_view rest = bytes;
    if (take_line(rest) != "ply") fail(file, "is no PLY file: its first line is not ply");
    std::string format;
    std::size_t count = 0, stride = 0;
    bool vertices = false, begun = false;  // whether the properties read are the vertices'
    struct Property {
        Kind kind;
        std::size_t offset, column;
    };
    std::array<std::optional<Property>, 3> axes;
    std::size_t columns = 0;
    while (true) {
        const auto line = take_line(rest);
        if (!line) fail(file, "ends within its header");
        const std::vector<std::string_view> words = words_of(*line);
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
        if (words[0] == "end_header") break;
        if (words[0] == "format" && words.size() == 3) format = words[1];
        if (words[0] == "element") {
            vertices = words.size() == 3 && words[1] == "vertex" && !begun;
            if (!begun && !vertices) fail(file, "has other elements before its vertices");
            if (vertices) {
                const auto number = number_of<std::size_t>(words[2]);
                if (!number) fail(file, fmt::format("has {} vertices", words[2]));
                count = *number;
            }
            begun = true;
        }
        if (words[0] != "property" || !vertices) continue;
        const auto kind = words.size() == 3 ? kPlyKinds.find(words[1]) : kPlyKinds.end();
        if (kind == kPlyKinds.end()) fail(file, "has vertices with lists, or numbers of an unknown type");
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (words[2] == std::string_view("xyz").substr(axis, 1))
                axes[axis] = Property{kind->second, stride, columns};
        stride += kind->second.bytes;
        ++columns;
    }
    if (!axes[0] || !axes[1] || !axes[2]) fail(file, "has vertices without x, y and z");
    if (count == 0) fail(file, "has no vertices");
    std::vector<glm::dvec3> points;
    if (format == "ascii") {
        for (std::size_t i = 0; i < count; ++i) {
            const auto line = take_line(rest);
            const auto words = line ? words_of(*line) : std::vector<std::string_view>();
            glm::dvec3 point;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t column = axes[axis]->column;
                const auto number = column < words.size() ? number_of<double>(words[column]) : std::nullopt;
                if (!number) fail(file, fmt::format("vertex {} is not {} numbers", i + 1, columns));
                point[static_cast<int>(axis)] = *number;
            }
            points.push_back(finite(file, point, i + 1));
        }
        return points;
    }
    if (format != "binary_little_endian" && format != "binary_big_endian")
        fail(file, fmt::format("has format {}; ascii, binary_little_endian and binary_big_endian can be read",
                               format));
    if (count > rest.size() / stride)
        fail(file, fmt::format("ends too early: {} vertices need {} bytes each, and there are {}", count,
                               stride, rest.size()));
    const bool swapped = (format == "binary_big_endian") == (std::endian::native == std::endian::little);
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        glm::dvec3 point;
        for (std::size_t axis = 0; axis < 3; ++axis)
            point[static_cast<int>(axis)] =
                read_number(axes[axis]->kind, rest.data() + i * stride + axes[axis]->offset, swapped);
        points.push_back(finite(file, point, i + 1));
    }
    return points;
}

void write_ply(std::ostream& out, std::span<const glm::dvec3> points) {
    out << "ply\nformat binary_little_endian 1.0\ncomment Dapple\nelement vertex " << points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    for (const glm::dvec3& point : points)
        for (int axis = 0; axis < 3; ++axis) {
            const auto number = static_cast<float>(point[axis]);
            std::array<char, sizeof(number)> bytes;
            std::memcpy(bytes.data(), &number, sizeof(number));
            if (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
            out.write(bytes.data(), bytes.size());
        }
}

void write_points_csv(std::ostream& out, std::span<const glm::dvec3> points) {
    out << "x,y,z\n";
    for (const glm::dvec3& point : points)
        out << fmt::format("{},{},{}\n", static_cast<float>(point.x), static_cast<float>(point.y),
                           static_cast<float>(point.z));
}

}  // namespace dapple
