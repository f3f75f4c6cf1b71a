#include "lab/volume/volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "io/files/picture.h"
#include "io/files/text_file.h"

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

// Squares of what is no further off are numbers.
constexpr double kFarthestFromOrigin = 1e100;

glm::dvec3 finite(const std::filesystem::path& file, const glm::dvec3& point, std::size_t number) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(point[axis])) fail(file, fmt::format("vertex {} is nowhere", number));
        if (std::abs(point[axis]) > kFarthestFromOrigin)
            fail(file, fmt::format("vertex {} is further off than {:g}; scale the cloud down first", number,
                                   kFarthestFromOrigin));
    }
    return point;
}

// By their names without blanks, in small letters.
using NrrdFields = std::map<std::string, std::string, std::less<>>;

// All that the format has. What places voxels or says how they are stored is followed or refused; the others
// tell people something.
constexpr std::array kNrrdFields = std::to_array<std::string_view>({"dimension",
                                                                    "type",
                                                                    "encoding",
                                                                    "endian",
                                                                    "sizes",
                                                                    "spacings",
                                                                    "lineskip",
                                                                    "byteskip",
                                                                    "spaceorigin",
                                                                    "spacedirections",
                                                                    "content",
                                                                    "number",
                                                                    "sampleunits",
                                                                    "thicknesses",
                                                                    "centers",
                                                                    "centerings",
                                                                    "labels",
                                                                    "units",
                                                                    "kinds",
                                                                    "space",
                                                                    "spacedimension",
                                                                    "spaceunits",
                                                                    "measurementframe",
                                                                    "oldmin",
                                                                    "oldmax",
                                                                    "blocksize"});

// The header, up to its empty line.
NrrdFields take_nrrd_fields(const std::filesystem::path& file, std::string_view& rest) {
    if (!take_line(rest).value_or("").starts_with("NRRD000"))
        fail(file, "is no NRRD file: it does not begin with NRRD000");
    NrrdFields fields;
    while (true) {
        const auto line = take_line(rest);
        if (!line) fail(file, "ends before its voxels begin");
        if (line->empty()) return fields;
        if (line->starts_with('#')) continue;
        const std::size_t colon = line->find(':');
        const std::string_view name = trimmed(line->substr(0, std::min(colon, line->size())));
        if (colon == line->npos) fail(file, fmt::format("has a line that is no field: {}", printable(name)));
        if (line->substr(colon).starts_with(":=")) continue;  // of whoever wrote it
        std::string key;
        for (const char c : name)
            if (c != ' ') key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        if (key == "datafile")
            fail(file, "has its voxels in another file; save them in one (.nrrd in place of .nhdr)");
        if (key == "axismins" || key == "axismaxs")
            fail(file, fmt::format("has {}, which cannot be read; give spacings and a space origin instead",
                                   printable(name)));
        if (std::ranges::find(kNrrdFields, key) == kNrrdFields.end())
            fail(file, fmt::format("has a field {}, which is none of NRRD's", printable(name)));
        if (!fields.emplace(key, trimmed(line->substr(colon + 1))).second)
            fail(file, fmt::format("has the field {} twice", printable(name)));
    }
}

// "(1,2,3)", as NRRD has it.
std::optional<glm::dvec3> vector_in(std::string_view text) {
    if (!text.starts_with('(') || !text.ends_with(')')) return std::nullopt;
    const auto numbers = numbers_of<double, 3>(text.substr(1, text.size() - 2), ",,");
    if (!numbers) return std::nullopt;
    return glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

// How large voxels are, and where the first one is.
void place_nrrd(const std::filesystem::path& file, const NrrdFields& fields, Volume& volume) {
    constexpr double kSmallest = 1e-30, kLargest = 1e30;
    const auto check = [&](double spacing, std::string_view text) {
        if (!(spacing >= kSmallest && spacing <= kLargest))
            fail(file, fmt::format("has voxels that are {} wide; {:g} to {:g} can be read", text, kSmallest,
                                   kLargest));
        return spacing;
    };
    const auto spacings = fields.find("spacings"), directions = fields.find("spacedirections"),
               origin = fields.find("spaceorigin");
    if (spacings != fields.end() && directions != fields.end())
        fail(file, "has both spacings and space directions; leave one of them out");
    if (spacings != fields.end()) {
        const std::vector<std::string_view> words = words_of(spacings->second);
        if (words.size() != 3) fail(file, fmt::format("has {} spacings; give 3", words.size()));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto number = number_of<double>(words[axis]);
            volume.spacing[static_cast<int>(axis)] = check(number.value_or(0), words[axis]);
        }
    }
    if (directions != fields.end()) {
        const std::vector<std::string_view> words = words_of(directions->second);
        if (words.size() != 3) fail(file, fmt::format("has {} space directions; give 3", words.size()));
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view text = words[static_cast<std::size_t>(axis)];
            const auto way = vector_in(text);
            if (!way) fail(file, fmt::format("has a space direction {}, which is not such as (1,0,0)", text));
            glm::dvec3 along(0);
            along[axis] = (*way)[axis];
            if (*way != along || !((*way)[axis] > 0))
                fail(file, fmt::format(
                               "has voxels that are turned or mirrored by the space direction {}; save them "
                               "along x, y and z",
                               text));
            volume.spacing[axis] = check(along[axis], text);
        }
    }
    if (origin == fields.end()) return;
    const auto middle = vector_in(origin->second);
    if (!middle)
        fail(file, fmt::format("has a space origin {}, which is not such as (0,0,0)", origin->second));
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs((*middle)[axis]) <= kLargest))
            fail(file, fmt::format("has a space origin {}, which is further off than {:g}", origin->second,
                                   kLargest));
    volume.corner = *middle - 0.5 * volume.spacing;
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
    const NrrdFields fields = take_nrrd_fields(file, rest);
    const auto field = [&](const char* name) -> std::string_view {
        const auto there = fields.find(name);
        return there == fields.end() ? std::string_view() : std::string_view(there->second);
    };
    if (field("encoding") != "raw")
        fail(file, fmt::format("has encoding {}; only raw can be read", field("encoding")));
    const auto kind = kNrrdKinds.find(field("type"));
    if (kind == kNrrdKinds.end())
        fail(file, fmt::format("has voxels of type {}; uchar, ushort, short, float and double can be read",
                               field("type")));
    const std::size_t voxel_bytes = kind->second.bytes;
    const std::string_view endian = field("endian");
    if (voxel_bytes > 1 && endian != "little" && endian != "big")
        fail(file,
             fmt::format("has {} for endian; voxels of several bytes need endian: little or endian: big",
                         endian.empty() ? "nothing" : endian));
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
    place_nrrd(file, fields, volume);
    const double voxels = static_cast<double>(volume.size.x) * volume.size.y * volume.size.z,
                 needed = voxels * static_cast<double>(voxel_bytes);
    const auto skipped = [&](const char* name) {
        const auto number = field(name).empty() ? 0 : number_of<long long>(field(name));
        if (!number || *number < (std::string_view(name) == "byteskip" ? -1 : 0))
            fail(file,
                 fmt::format("has a {} of {}",
                             name == std::string_view("byteskip") ? "byte skip" : "line skip", field(name)));
        return *number;
    };
    for (long long lines = skipped("lineskip"); lines > 0; --lines)
        if (!take_line(rest)) fail(file, "ends within the lines that it has skipped");
    // -1: the voxels are the last there is.
    const long long skip = skipped("byteskip");
    const double begin = skip < 0 ? static_cast<double>(rest.size()) - needed : static_cast<double>(skip);
    if (begin < 0 || begin + needed > static_cast<double>(rest.size()))
        fail(file,
             fmt::format("ends too early: {} x {} x {} voxels need {:.0f} bytes, and there are {}",
                         volume.size.x, volume.size.y, volume.size.z, needed,
                         rest.size() - std::min(rest.size(), static_cast<std::size_t>(std::max(skip, 0LL)))));
    rest.remove_prefix(static_cast<std::size_t>(begin));
    const bool swapped = (endian == "big") == (std::endian::native == std::endian::little);
    volume.density.resize(static_cast<std::size_t>(voxels));
    for (std::size_t i = 0; i < volume.density.size(); ++i)
        volume.density[i] =
            static_cast<float>(read_number(kind->second, rest.data() + i * voxel_bytes, swapped));
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
        if (words[0] != "end_header" && words[0] != "format" && words[0] != "element" &&
            words[0] != "property")
            fail(file, fmt::format("has a line in its header that is none of PLY's: {}", printable(*line)));
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
            if (words[2] == std::string_view("xyz").substr(axis, 1)) {
                if (axes[axis]) fail(file, fmt::format("has vertices with {} twice", words[2]));
                axes[axis] = Property{kind->second, stride, columns};
            }
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

namespace {

bool is_float(double number) {
    return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()) &&
           static_cast<double>(static_cast<float>(number)) == number;
}

template <class Number>
void put_points(std::ostream& out, std::span<const glm::dvec3> points) {
    for (const glm::dvec3& point : points)
        for (int axis = 0; axis < 3; ++axis) {
            const auto number = static_cast<Number>(point[axis]);
            std::array<char, sizeof(number)> bytes;
            std::memcpy(bytes.data(), &number, sizeof(number));
            if (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
            out.write(bytes.data(), bytes.size());
        }
}

}  // namespace

void write_ply(std::ostream& out, std::span<const glm::dvec3> points) {
    const bool floats = std::ranges::all_of(points, [](const glm::dvec3& point) {
        return is_float(point.x) && is_float(point.y) && is_float(point.z);
    });
    const char* const kind = floats ? "float" : "double";
    out << "ply\nformat binary_little_endian 1.0\ncomment Dapple\nelement vertex " << points.size();
    for (const char axis : {'x', 'y', 'z'}) out << "\nproperty " << kind << ' ' << axis;
    out << "\nend_header\n";
    floats ? put_points<float>(out, points) : put_points<double>(out, points);
}

void write_points_csv(std::ostream& out, std::span<const glm::dvec3> points) {
    const auto text = [](double number) {
        return is_float(number) ? fmt::format("{}", static_cast<float>(number)) : fmt::format("{}", number);
    };
    out << "x,y,z\n";
    for (const glm::dvec3& point : points)
        out << text(point.x) << ',' << text(point.y) << ',' << text(point.z) << '\n';
}

}  // namespace dapple
