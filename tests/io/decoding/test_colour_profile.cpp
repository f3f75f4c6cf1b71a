#include <doctest/doctest.h>
#include <lcms2.h>

#include <array>
#include <cmath>
#include <string>

#include "io/files/picture.h"
#include "tests/picture_files.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

std::string bytes_of(cmsHPROFILE profile) {
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    std::string bytes(size, '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    return bytes;
}

std::string profile_of(const cmsCIExyYTRIPLE& primaries, cmsCIExyY white, double gamma) {
    cmsToneCurve* const curve = cmsBuildGamma(nullptr, gamma);
    std::array<cmsToneCurve*, 3> curves{curve, curve, curve};
    const std::string bytes = bytes_of(cmsCreateRGBProfile(&white, &primaries, curves.data()));
    cmsFreeToneCurve(curve);
    return bytes;
}

constexpr double kAdobeGamma = 563.0 / 256;

// Adobe RGB (1998), section 4.3.
std::string adobe_rgb() {
    return profile_of({{0.64, 0.33, 1}, {0.21, 0.71, 1}, {0.15, 0.06, 1}}, {0.3127, 0.3290, 1}, kAdobeGamma);
}

std::string grey_of(double gamma) {
    cmsToneCurve* const curve = cmsBuildGamma(nullptr, gamma);
    const std::string bytes = bytes_of(cmsCreateGrayProfile(cmsD50_xyY(), curve));
    cmsFreeToneCurve(curve);
    return bytes;
}

PictureFile flat(int channels, std::vector<float> colour, const std::string& profile, int side = 8) {
    std::vector<float> values;
    for (int i = 0; i < side * side; ++i) values.insert(values.end(), colour.begin(), colour.end());
    return {.width = side, .height = side, .channels = channels, .values = values, .profile = profile};
}

constexpr std::array kEndings{".png", ".tif", ".jpg"};

}  // namespace

TEST_CASE("a picture's own colour profile says what light its values are") {
    const TemporaryFolder folder;
    const std::vector<float> stored{153 / 255.0f, 128 / 255.0f, 77 / 255.0f};
    const auto light = [&](int k) { return std::pow(double(stored[std::size_t(k)]), kAdobeGamma); };
    // Adobe RGB (1998), section 4.3.5.3: luminance, which is that of sRGB, whose white is the same.
    const double luminance = 0.29734 * light(0) + 0.62736 * light(1) + 0.07529 * light(2);
    for (const char* const ending : kEndings) {
        CAPTURE(std::string(ending));
        const auto file = folder / (std::string("a") + ending);
        write_picture(file, flat(3, stored, adobe_rgb()));
        const double tolerance = std::string(ending) == ".jpg" ? 0.01 : 0.002;
        CHECK(read_picture(file).light.at(4, 4) == doctest::Approx(luminance).epsilon(tolerance));
        write_picture(file, flat(3, stored, ""));
        CHECK(std::abs(read_picture(file).light.at(4, 4) - luminance) > 0.01);
    }
}

TEST_CASE("a grey picture has a profile of its own kind, transparent parts show the paper") {
    const TemporaryFolder folder;
    for (const char* const ending : kEndings) {
        CAPTURE(std::string(ending));
        const auto file = folder / (std::string("grey") + ending);
        write_picture(file, flat(1, {128 / 255.0f}, grey_of(1.4)));
        const Picture picture = read_picture(file, PictureLimit::usual, PictureColours::kept);
        CHECK(picture.light.at(4, 4) == doctest::Approx(std::pow(128 / 255.0, 1.4)).epsilon(0.003));
    }
    for (const char* const ending : {".png", ".tif"}) {
        const auto file = folder / (std::string("half") + ending);
        write_picture(file, flat(4, {0.2f, 0.2f, 0.2f, 0.6f},
                                 profile_of({{0.64, 0.33, 1}, {0.3, 0.6, 1}, {0.15, 0.06, 1}},
                                            {0.3127, 0.3290, 1}, 1.4)));
        CHECK(read_picture(file).light.at(4, 4) ==
              doctest::Approx(0.6 * std::pow(0.2, 1.4) + 0.4).epsilon(0.003));
    }
}

TEST_CASE("a profile that says nothing new, is of another kind or is broken changes nothing") {
    const TemporaryFolder folder;
    const std::vector<float> colour{0.8f, 0.4f, 0.2f};
    const auto light_with = [&](const std::string& profile) {
        write_picture(folder / "a.tif", flat(3, colour, profile));
        return read_picture(folder / "a.tif").light.at(4, 4);
    };
    const float plain = light_with("");
    CHECK(light_with(bytes_of(cmsCreate_sRGBProfile())) == plain);
    CHECK(light_with(grey_of(1.4)) == plain);
    CHECK(light_with(adobe_rgb().substr(0, 200)) == plain);
    CHECK(light_with("no profile at all") == plain);
}

TEST_CASE("a first look has the profile's colours too") {
    const TemporaryFolder folder;
    write_picture(folder / "a.jpg", flat(3, {0.6f, 0.5f, 0.3f}, adobe_rgb(), 1800));
    const auto look = read_first_look(folder / "a.jpg");
    REQUIRE(look);
    CHECK(look->light.at(100, 100) ==
          doctest::Approx(read_picture(folder / "a.jpg").light.at(200, 200)).epsilon(0.002));
}
