#include <doctest/doctest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "io/decoding/decoder_process.h"
#include "io/decoding/image_pipe.h"
#include "io/descriptor.h"
#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/fuzz/mutations.h"
#include "tests/temporary_folder.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

// What a decoder sends, put together by hand: image_pipe.cpp's own numbers are not asked.
template <class Number>
std::string bytes_of(Number number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
}

struct Sent {
    std::int32_t width = 3, height = 2, orientation = 1, grey = 0, scene_light = 0;
    std::string description = "3 x 2 pixels", remark = "";

    std::string header() const {
        std::string bytes = "p";
        for (const std::int32_t number : {width, height, orientation, grey, scene_light})
            bytes += bytes_of(number);
        for (const std::string& text : {description, remark})
            bytes += bytes_of(static_cast<std::uint32_t>(text.size())) + text;
        return bytes;
    }
};

std::string row(const std::vector<float>& values) {
    std::string bytes = "r";
    for (const float value : values) bytes += bytes_of(value);
    return bytes;
}

std::string row_of(std::size_t values, float value) {
    return row(std::vector<float>(values, value));
}

Descriptor memory_with(const std::string& bytes) {
    Descriptor file(::memfd_create("sent", 0));
    REQUIRE(::write(file.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
    ::lseek(file.get(), 0, SEEK_SET);
    return file;
}

// As the program takes it.
struct Taken : ImageSink {
    void begin(const ImageHeader& given) override {
        header = given;
        builder.emplace(given.width, given.height, ExifOrientation{given.orientation}, PictureColours::kept);
    }
    void row(std::span<const glm::vec3> colours) override { builder->add_row(rows++, colours); }
    ImageHeader header;
    std::optional<PictureBuilder> builder;
    int rows = 0;
};

// What is said of it: "" if it is a picture, "ended" if it is cut off.
std::string said_of(const std::string& bytes, const DecodeRequest& request = {.most_pixels = 10'000}) {
    const Descriptor file = memory_with(bytes);
    Taken taken;
    try {
        return receive_image(file.get(), request, taken) ? "" : "ended";
    } catch (const DecodeError& error) {
        return error.what();
    }
}

const std::string kRows = row_of(9, 0.25f) + row_of(9, 1.0f);

}  // namespace

TEST_CASE("a decoder's picture arrives as it was sent, in colours and in grey") {
    for (const bool grey : {false, true}) {
        const Descriptor file(::memfd_create("sent", 0));
        ImagePipe pipe(file.get());
        pipe.expect(1000);
        pipe.begin({.width = 2,
                    .height = 1,
                    .orientation = 6,
                    .grey = grey,
                    .description = "two",
                    .scene_light = true});
        const std::array sent = {glm::vec3(-0.5f), grey ? glm::vec3(3) : glm::vec3(0, 1, 1e17f)};
        pipe.row(sent);
        pipe.finish();
        ::lseek(file.get(), 0, SEEK_SET);
        struct : ImageSink {
            void begin(const ImageHeader& given) override { header = given; }
            void row(std::span<const glm::vec3> given) override {
                colours.insert(colours.end(), given.begin(), given.end());
            }
            ImageHeader header;
            std::vector<glm::vec3> colours;
        } taken;
        REQUIRE(receive_image(file.get(), {}, taken));
        CHECK(taken.header.width == 2);
        CHECK(taken.header.height == 1);
        CHECK(taken.header.orientation == 6);
        CHECK(taken.header.grey == grey);
        CHECK(taken.header.description == "two");
        CHECK(taken.header.scene_light);
        CHECK(taken.colours == std::vector(sent.begin(), sent.end()));
    }
}

TEST_CASE("what a decoder says is not believed: what cannot be is a sentence") {
    const std::string sane = Sent().header() + kRows;
    REQUIRE(said_of(sane) == "");
    const std::string lies = "its decoder sent something impossible: ";
    for (const int orientation : {0, 9, -1, 1 << 30})
        CHECK(said_of(Sent{.orientation = orientation}.header() + kRows) ==
              lies + "orientation " + std::to_string(orientation));
    CHECK(said_of(Sent{.grey = 2}.header() + kRows) == lies + "2 for grey");
    CHECK(said_of(Sent{.scene_light = -1}.header() + kRows) == lies + "-1 for light of a scene");
    CHECK(said_of(Sent{.width = 0}.header() + kRows) == "there is no picture in the file");
    CHECK(said_of(Sent{.height = -2}.header() + kRows) == "there is no picture in the file");
    CHECK(said_of(Sent{.width = 1 << 30, .height = 1 << 30}.header() + kRows, {}) ==
          "1,073,741,824 x 1,073,741,824 pixels are over 400 megapixels");
    CHECK(said_of(Sent{.width = 1'000'001, .height = 1}.header(), {.most_pixels = kAnyPixels}) ==
          "has 1,000,001 x 1 pixels, where a side has at most 1,000,000");
    CHECK(said_of(Sent{.description = std::string(5000, 'a')}.header() + kRows) ==
          lies + "a text of 5,000 bytes");
    CHECK(said_of(sane + "r") == lies + "something after the last row");
    CHECK(said_of(sane + row_of(9, 0)) == lies + "something after the last row");
    CHECK(said_of("e" + bytes_of(std::uint32_t{0})) == lies + "an error without a text");
    CHECK(said_of(Sent().header() + row_of(9, 0) + "z") == "its decoder sent nothing that can be understood");
    CHECK(said_of("") == "ended");
    for (std::size_t bytes = 1; bytes < sane.size(); ++bytes)
        CHECK(said_of(sane.substr(0, bytes)) == "ended");
    // Sizes without an end, and one that is no size.
    std::string sizes;
    for (int i = 0; i < 1000; ++i) sizes += "s" + bytes_of(std::uint64_t{1});
    CHECK(said_of(sizes) == "its decoder sent nothing that can be understood");
    CHECK(said_of("s" + bytes_of(UINT64_MAX) + sane, {.most_pixels = kAnyPixels}) == "");
}

TEST_CASE("rows that are no light are refused wherever they come, and every light goes through") {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::string no_light =
        "its decoder sent something impossible: a row 1 with values that are no light";
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 1e38f, -1e38f, 1.1e18f}) {
        for (const std::int32_t grey : {0, 1}) {
            const std::size_t values = grey ? 3 : 9;
            for (std::size_t at = 0; at < values; ++at) {
                std::vector<float> light(values, 0.5f);
                light[at] = value;
                CHECK(said_of(Sent{.grey = grey}.header() + row_of(values, 0) + row(light)) == no_light);
            }
        }
    }
    // The largest make no sum infinite that a picture is made of.
    const Descriptor file = memory_with(Sent{.width = 100, .height = 100}.header() + [] {
        std::string rows;
        for (int y = 0; y < 100; ++y) rows += row_of(300, 1e18f);
        return rows;
    }());
    Taken taken;
    REQUIRE(receive_image(file.get(), {}, taken));
    const Picture picture = taken.builder->finish("", true);
    for (const float light : picture.light.values) REQUIRE(std::isfinite(light));
    CHECK(std::isfinite(picture.exposure));
}

TEST_CASE("what a decoder says to people commands no terminal") {
    const std::string sentence = "bad\x1b[2J\n";
    CHECK(said_of("e" + bytes_of(static_cast<std::uint32_t>(sentence.size())) + sentence) ==
          "bad\\x1b[2J\\n");
    const Descriptor file =
        memory_with(Sent{.description = "3\x1b[2J", .remark = "4\x1b[2J"}.header() + kRows);
    Taken taken;
    REQUIRE(receive_image(file.get(), {}, taken));
    CHECK(taken.header.description == "3\\x1b[2J");
    CHECK(taken.header.remark == "4\\x1b[2J");
}

TEST_CASE("thousands of nearly right things that a decoder could send are each a picture or a sentence") {
    std::mt19937_64 random(51);
    const std::string colour = "s" + bytes_of(std::uint64_t{72}) + Sent{.orientation = 6}.header() + kRows,
                      grey = Sent{.orientation = 8, .grey = 1}.header() + row_of(3, 0) + row_of(3, 1),
                      error = "e" + bytes_of(std::uint32_t{3}) + "bad";
    int pictures = 0, sentences = 0, ended = 0;
    for (int i = 0; i < 4000; ++i) {
        const std::string& seed = i % 8 == 0 ? error : i % 2 == 0 ? grey : colour;
        std::string bytes = seed;
        if (i % 16 == 1) {
            // Nothing that is right, but for its beginning.
            bytes = "p";
            for (int k = 0; k < 100; ++k) bytes += static_cast<char>(random());
        } else {
            bytes = mutated(bytes, random);
        }
        const std::string said = said_of(bytes);
        ++(said.empty() ? pictures : said == "ended" ? ended : sentences);
    }
    // There are many of each, or this would look at nothing.
    CHECK(pictures > 100);
    CHECK(sentences > 100);
    CHECK(ended > 100);
}

TEST_CASE("a picture of an orientation that there is not is taken as upright") {
    for (const int orientation : {0, 9, -7, 1000}) {
        PictureBuilder builder(3, 1, {orientation});
        builder.add_row(0, std::vector{glm::vec3(0), glm::vec3(0.5f), glm::vec3(1)});
        const Picture picture = builder.finish("");
        REQUIRE(picture.light.width == 3);
        CHECK(picture.light.at(1, 0) == doctest::Approx(0.5));
    }
}

TEST_CASE("a decoder that neither works nor ends is waited for by the size that it tells") {
    const TemporaryFolder folder;
    put_text(folder / "picture", "P5 1 1 255\nx");
    const auto seconds_of = [&](const std::string& commands) {
        put_text(folder / "decoder", "#!/bin/sh\n" + commands + "\nexec sleep 1000\n");
        fs::permissions(folder / "decoder", fs::perms::owner_all);
        const auto begin = std::chrono::steady_clock::now();
        Taken taken;
        CHECK_THROWS_WITH_AS(
            decode_file_by(
                folder / "decoder", folder / "picture", {.most_pixels = 1'000'000}, taken,
                {.at_first = std::chrono::milliseconds(100), .per_megabyte = std::chrono::milliseconds(20)}),
            "takes far longer to decode than a picture of its size should", DecodeError);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const auto at_least = [&](double seconds, const std::string& commands) {
        const double waited = seconds_of(commands);
        CHECK(waited >= seconds);
        CHECK(waited < 100);  // however busy the machine is
    };
    at_least(0.1, "");
    // In the middle of what it says: 20 million bytes, and a header.
    at_least(0.5, R"(printf 's\000\055\061\001\0\0\0\0')");
    at_least(0.5, R"(printf 's\000\055\061\001\0\0\0\0p\001\0\0\0')");
    // So many bytes no picture of a million pixels has: 32 millions are waited for.
    at_least(0.74, R"(printf 's\377\377\377\377\377\377\377\377')");
    // A byte now and then does not make it longer.
    at_least(0.1, "printf p; for i in 1 2 3 4 5 6 7 8 9 10 11 12 13; do sleep 0.03; printf '\\001'; done");
}
