// JPEG XL, beside the same picture in a format that another decoder reads; cjxl, of libjxl, makes it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/files/environment_file.h"
#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/temporary_folder.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

void run(const std::string& command) {
    REQUIRE_MESSAGE(std::system((command + " >/dev/null 2>&1").c_str()) == 0, command);
}

std::string sentence_of(const fs::path& path) {
    try {
        read_picture(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

constexpr int kWidth = 40, kHeight = 20;
constexpr double kStep = 2.5e-3;  // of colours as they are kept

PictureFile many_values(int channels, const std::string& type) {
    PictureFile file{.width = kWidth, .height = kHeight, .channels = channels, .type = type};
    for (int i = 0; i < kWidth * kHeight * channels; ++i)
        file.values.push_back(static_cast<float>(i * 7919 % 1009) / 1008.0f);
    return file;
}

double differ(const Picture& a, const Picture& b) {
    REQUIRE(a.light.width == b.light.width);
    REQUIRE(a.light.height == b.light.height);
    double most = 0;
    for (std::size_t i = 0; i < a.light.values.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(a.light.values[i]) - b.light.values[i]));
    for (std::size_t i = 0; i < a.colours.values.size(); ++i)
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(static_cast<double>(unpacked(a.colours.values[i])[c]) -
                                           unpacked(b.colours.values[i])[c]));
    return most;
}

Picture coloured(const fs::path& path) {
    return read_picture(path, PictureLimit::usual, PictureColours::kept);
}

}  // namespace

TEST_CASE("a JPEG XL without losses is the picture that it was made of") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    for (const char* const type : {"uint8", "uint16"})
        for (int channels = 1; channels <= 4; ++channels) {
            CAPTURE(std::string(type));
            CAPTURE(channels);
            write_picture(folder / "a.png", many_values(channels, type));
            for (const char* const container : {"0", "1"}) {
                run("cjxl -d 0 --container=" + std::string(container) + " " + in + "a.png " + in + "a.jxl");
                const Picture png = coloured(folder / "a.png"), jxl = coloured(folder / "a.jxl");
                CHECK(differ(jxl, png) < kStep);
                std::string described = png.description;
                described.replace(described.size() - 3, 3, "jxl");
                CHECK(jxl.description == described);
            }
        }
    // Light of a scene, and what is brighter than white.
    PictureFile light = many_values(3, "float");
    for (float& value : light.values) value *= 20;
    write_picture(folder / "a.exr", light);
    // PFM, from the bottom up.
    std::string pfm = "PF\n" + std::to_string(kWidth) + " " + std::to_string(kHeight) + "\n-1.0\n";
    for (int y = kHeight; y-- > 0;)
        pfm.append(reinterpret_cast<const char*>(light.values.data() + y * kWidth * 3),
                   kWidth * 3 * sizeof(float));
    put_text(folder / "a.pfm", pfm);
    run("cjxl -d 0 -x color_space=RGB_D65_SRG_Rel_Lin " + in + "a.pfm " + in + "a.jxl");
    const Picture exr = coloured(folder / "a.exr"), jxl = coloured(folder / "a.jxl");
    CHECK(differ(jxl, exr) < 1e-4);
    CHECK(jxl.exposure == doctest::Approx(exr.exposure));
    CHECK_FALSE(read_environment(folder / "a.jxl").ends_at_white);
    // With losses it looks the same.
    write_picture(folder / "a.png", {.width = kWidth,
                                     .height = kHeight,
                                     .channels = 3,
                                     .values = std::vector<float>(kWidth * kHeight * 3, 0.6f)});
    run("cjxl -d 1 " + in + "a.png " + in + "a.jxl");
    CHECK(differ(coloured(folder / "a.jxl"), coloured(folder / "a.png")) < 0.02);
}

TEST_CASE("a JPEG XL has the colours that its profile or its numbers say") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    PictureFile file = many_values(3, "uint16");
    for (const char* const space : {"linear", "sRGB"}) {
        file.colour_space = space;
        write_picture(folder / "a.png", file);
        run("cjxl -d 0 " + in + "a.png " + in + "a.jxl");
        CHECK(differ(coloured(folder / "a.jxl"), coloured(folder / "a.png")) < 1e-3);
    }
    // Numbers of which a PNG says the same: the matrix of CSS Color 4's Display P3, by hand.
    file = {.width = 8, .height = 8, .channels = 3, .type = "uint16"};
    for (int i = 0; i < 64; ++i) file.values.insert(file.values.end(), {0.5f, 0.25f, 0.25f});
    write_picture(folder / "a.png", file);
    run("cjxl -d 0 -x color_space=RGB_D65_DCI_Rel_Lin " + in + "a.png " + in + "p3.jxl");
    run("cjxl -d 0 -x color_space=RGB_D65_202_Rel_PeQ " + in + "a.png " + in + "pq.jxl");
    const glm::vec3 p3 = unpacked(coloured(folder / "p3.jxl").colours.values[9]);
    CHECK(p3.x == doctest::Approx(0.55624).epsilon(2e-3));
    CHECK(p3.y == doctest::Approx(0.23951).epsilon(2e-3));
    CHECK(p3.z == doctest::Approx(0.24500).epsilon(2e-3));
    // Rec. BT.2100: 58 % of PQ is 203 cd/m2, which is white here.
    file.values.assign(64 * 3, 0.58f);
    write_picture(folder / "a.png", file);
    run("cjxl -d 0 -x color_space=RGB_D65_202_Rel_PeQ " + in + "a.png " + in + "pq.jxl");
    CHECK(read_picture(folder / "pq.jxl").light.at(3, 3) == doctest::Approx(1).epsilon(0.02));
}

TEST_CASE("a JPEG XL is turned upright once, whatever the EXIF that it was given says too") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    for (int orientation = 1; orientation <= 8; ++orientation) {
        CAPTURE(orientation);
        const bool on_its_side = orientation > 4;
        PictureFile file{.width = on_its_side ? 32 : 64,
                         .height = on_its_side ? 64 : 32,
                         .channels = 3,
                         .orientation = orientation};
        for (int i = 0; i < 64 * 32; ++i) {
            const int x = i % file.width, y = i / file.width;
            for (int c = 0; c < 3; ++c) file.values.push_back(x < 12 ? 0.8f : y < 12 ? 0.5f : 0.2f);
        }
        write_picture(folder / "a.jpg", file);
        run("cjxl " + in + "a.jpg " + in + "a.jxl");
        const Picture jpeg = read_picture(folder / "a.jpg"), jxl = read_picture(folder / "a.jxl");
        CHECK(jxl.light.width == 64);
        CHECK(differ(jxl, jpeg) < 0.03);
        const EnvironmentMap map = read_environment(folder / "a.jxl").map;
        CHECK(map.radiance().at(40, 25).y == doctest::Approx(jxl.light.at(40, 25)).epsilon(1e-3));
    }
}

TEST_CASE("of a JPEG XL that moves the first picture is read") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    // Without a delay they would be layers of one picture.
    run("convert -delay 50 -size 20x10 xc:'#404040' xc:'#c0c0c0' " + in + "a.gif");
    run("cjxl -d 0 " + in + "a.gif " + in + "a.jxl");
    CHECK(differ(read_picture(folder / "a.jxl"), read_picture(folder / "a.gif")) < 1e-5);
}

TEST_CASE("a JPEG XL that is damaged or too large is refused in a sentence") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    write_picture(folder / "a.png", many_values(3, "uint8"));
    for (const char* const way : {"-d 0", "-d 1 --container=1"}) {
        run(std::string("cjxl ") + way + " " + in + "a.png " + in + "a.jxl");
        const std::string whole = text_of(folder / "a.jxl");
        for (std::size_t part = 1; part < 12; ++part) {
            put_text(folder / "b.jxl", whole.substr(0, whole.size() * part / 12));
            const std::string sentence = sentence_of(folder / "b.jxl");
            CAPTURE(part);
            CHECK(sentence.starts_with((folder / "b.jxl").string() + ": "));
            CHECK(sentence.find('\n') == sentence.npos);
        }
        std::string other = whole;
        for (std::size_t i = whole.size() / 3; i < whole.size(); i += 3)
            other[i] = static_cast<char>(~other[i]);
        put_text(folder / "b.jxl", other);
        const std::string sentence = sentence_of(folder / "b.jxl");
        CHECK((sentence.empty() || sentence.starts_with((folder / "b.jxl").string() + ": ")));
    }
    // A header of 200,000 x 200,000 pixels, all else as usual: bits from the lowest on.
    constexpr std::uint64_t side = 200'000;
    std::uint64_t bits =
        std::uint64_t{3} << 1 | (side - 1) << 3 | std::uint64_t{1} << 33 | ~std::uint64_t{0} << 36;
    std::string large = "\xff\x0a";
    for (int i = 0; i < 8; ++i, bits >>= 8) large += static_cast<char>(bits & 255);
    put_text(folder / "large.jxl", large + std::string(1000, '\xff'));
    const std::string sentence = sentence_of(folder / "large.jxl");
    CAPTURE(sentence);
    CHECK(sentence.find("200,000 x 200,000 pixels are over 400 megapixels") != sentence.npos);
}
