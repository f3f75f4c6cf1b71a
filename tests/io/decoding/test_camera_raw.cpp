#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <glm/vec3.hpp>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

// A TIFF's entries: of bytes, text, 2-byte numbers, 4-byte ones and fractions of 10,000.
class Page {
 public:
    explicit Page(bool big_endian) : big_endian_(big_endian) {}

    void put(int tag, int type, const std::vector<std::int64_t>& values) {
        Entry& entry = entries_[tag];
        entry = {type, values.size(), {}};
        for (const std::int64_t value : values) {
            entry.bytes += number(value, type == 3 ? 2 : type == 4 || type >= 5 ? 4 : 1);
            if (type >= 5) entry.bytes += number(10'000, 4);
        }
    }

    std::string number(std::int64_t value, int bytes) const {
        std::string text;
        for (int i = 0; i < bytes; ++i)
            text += static_cast<char>(value >> 8 * (big_endian_ ? bytes - 1 - i : i));
        return text;
    }

    std::size_t size() const {
        std::size_t bytes = 6 + 12 * entries_.size();
        for (const auto& [tag, entry] : entries_)
            if (entry.bytes.size() > 4) bytes += entry.bytes.size();
        return bytes;
    }

    /// As it is at that place of a file.
    std::string text(std::size_t at) const {
        std::string page = number(static_cast<std::int64_t>(entries_.size()), 2), behind;
        for (const auto& [tag, entry] : entries_) {
            page +=
                number(tag, 2) + number(entry.type, 2) + number(static_cast<std::int64_t>(entry.count), 4);
            if (entry.bytes.size() <= 4) {
                page += entry.bytes + std::string(4 - entry.bytes.size(), '\0');
            } else {
                page += number(static_cast<std::int64_t>(at + 6 + 12 * entries_.size() + behind.size()), 4);
                behind += entry.bytes;
            }
        }
        return page + number(0, 4) + behind;
    }

 private:
    struct Entry {
        int type;
        std::size_t count;
        std::string bytes;
    };
    bool big_endian_;
    std::map<int, Entry> entries_;
};

constexpr int kByte = 1, kText = 2, kShort = 3, kLong = 4, kFraction = 5, kSignedFraction = 10;

// A colour of the light at a place of the sensor, 0..1.
using Scene = glm::dvec3 (*)(int x, int y);

struct Raw {
    int width = 64, height = 48;
    int orientation = 1;
    bool big_endian = false;
    bool behind_small_picture = false;  // as most cameras have it; else the first page, as some converters do
};

// What a sensor under red, green and blue filters sees, as a DNG of a camera whose colours are linear sRGB.
void write_dng(const std::filesystem::path& file, const Raw& raw, Scene scene) {
    Page sensor(raw.big_endian), small(raw.big_endian);
    std::string values;
    for (int y = 0; y < raw.height; ++y) {
        for (int x = 0; x < raw.width; ++x) {
            const double seen = scene(x, y)[(x & 1) + (y & 1)];
            values += sensor.number(static_cast<std::int64_t>(seen * 65'535 + 0.5), 2);
        }
    }
    const auto describe = [&](Page& page) {
        page.put(271, kText, {'A', 'n', 'y', 0});
        page.put(272, kText, {'O', 'n', 'e', 0});
        page.put(274, kShort, {raw.orientation});
        page.put(50706, kByte, {1, 4, 0, 0});
        page.put(50708, kText, {'A', 'n', 'y', ' ', 'O', 'n', 'e', 0});
        // From XYZ to linear sRGB, IEC 61966-2-1; and white that is white.
        page.put(50721, kSignedFraction, {32'405, -15'371, -4'985, -9'693, 18'760, 416, 556, -2'040, 10'572});
        page.put(50728, kFraction, {10'000, 10'000, 10'000});
        page.put(50778, kShort, {21});
    };
    sensor.put(254, kLong, {0});
    sensor.put(256, kLong, {raw.width});
    sensor.put(257, kLong, {raw.height});
    sensor.put(258, kShort, {16});
    sensor.put(259, kShort, {1});
    sensor.put(262, kShort, {32'803});
    sensor.put(273, kLong, {0});
    sensor.put(277, kShort, {1});
    sensor.put(278, kLong, {raw.height});
    sensor.put(279, kLong, {static_cast<std::int64_t>(values.size())});
    sensor.put(33421, kShort, {2, 2});
    sensor.put(33422, kByte, {0, 1, 1, 2});
    sensor.put(50714, kShort, {0});
    sensor.put(50717, kLong, {65'535});
    Page& first = raw.behind_small_picture ? small : sensor;
    describe(first);
    const std::string black(std::size_t{3} * 8 * 6, '\0');
    if (raw.behind_small_picture) {
        small.put(254, kLong, {1});
        small.put(256, kLong, {8});
        small.put(257, kLong, {6});
        small.put(258, kShort, {8, 8, 8});
        small.put(259, kShort, {1});
        small.put(262, kShort, {2});
        small.put(273, kLong, {0});
        small.put(277, kShort, {3});
        small.put(278, kLong, {6});
        small.put(279, kLong, {static_cast<std::int64_t>(black.size())});
        small.put(330, kLong, {0});
    }
    constexpr std::size_t kHead = 8;
    const std::size_t second = kHead + first.size();
    if (raw.behind_small_picture) small.put(330, kLong, {static_cast<std::int64_t>(second)});
    const std::size_t pixels = second + (raw.behind_small_picture ? sensor.size() : 0);
    sensor.put(273, kLong, {static_cast<std::int64_t>(pixels)});
    if (raw.behind_small_picture) small.put(273, kLong, {static_cast<std::int64_t>(pixels + values.size())});
    std::string bytes = (raw.big_endian ? "MM" : "II") + sensor.number(42, 2) + sensor.number(kHead, 4);
    bytes += first.text(kHead);
    if (raw.behind_small_picture) bytes += sensor.text(second);
    bytes += values;
    if (raw.behind_small_picture) bytes += black;
    std::ofstream(file, std::ios::binary) << bytes;
}

constexpr glm::dvec3 kLeft{0.5, 0.25, 0.125}, kRight{0.1, 0.2, 0.4};

glm::dvec3 two_halves(int x, int) {
    return x < 32 ? kLeft : kRight;
}

double luminance(glm::dvec3 c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

}  // namespace

TEST_CASE("a camera's raw file is developed, in its colours, and its small picture left alone") {
    const TemporaryFolder folder;
    for (const bool big_endian : {false, true}) {
        for (const bool behind : {false, true}) {
            CAPTURE(big_endian);
            CAPTURE(behind);
            write_dng(folder / "a.dng", {.big_endian = big_endian, .behind_small_picture = behind},
                      two_halves);
            const Picture picture = read_picture(folder / "a.dng");
            REQUIRE(picture.light.width == 64);
            REQUIRE(picture.light.height == 48);
            CHECK(picture.light.at(10, 20) == doctest::Approx(luminance(kLeft)).epsilon(0.01));
            CHECK(picture.light.at(50, 20) == doctest::Approx(luminance(kRight)).epsilon(0.01));
            CHECK(picture.description == "64 x 48 pixels, 16-bit colour raw");
        }
    }
}

TEST_CASE("a raw file is seen as the camera was held") {
    const TemporaryFolder folder;
    write_dng(folder / "turned.nef", {.orientation = 6, .behind_small_picture = true},
              two_halves);  // to the right
    const Picture picture = read_picture(folder / "turned.nef");
    REQUIRE(picture.light.width == 48);
    REQUIRE(picture.light.height == 64);
    CHECK(picture.light.at(20, 10) == doctest::Approx(luminance(kLeft)).epsilon(0.01));
    CHECK(picture.light.at(20, 50) == doctest::Approx(luminance(kRight)).epsilon(0.01));
}

TEST_CASE("a first look at a large raw file is half its size; a cut one is no picture") {
    const TemporaryFolder folder;
    const auto ramp = [](int x, int) { return glm::dvec3(x / 2000.0); };
    write_dng(folder / "large.dng", {.width = 2000, .height = 1000, .behind_small_picture = true}, ramp);
    const auto look = read_first_look(folder / "large.dng");
    REQUIRE(look);
    CHECK(look->light.width == 1000);
    CHECK(look->light.height == 500);
    CHECK(look->description == "2000 x 1000 pixels, 16-bit colour raw");
    CHECK(look->light.at(500, 250) == doctest::Approx(0.5).epsilon(0.01));

    write_dng(folder / "small.dng", {}, two_halves);
    CHECK_FALSE(read_first_look(folder / "small.dng"));
    std::string bytes = text_of(folder / "large.dng");
    std::ofstream(folder / "cut.dng", std::ios::binary) << bytes.substr(0, 2000);
    CHECK_THROWS_WITH(read_picture(folder / "cut.dng"), doctest::Contains("cut.dng: "));
}
