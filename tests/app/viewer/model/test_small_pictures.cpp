#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/files/png_file.h"
#include "app/viewer/model/small_drawing.h"
#include "app/viewer/model/small_pictures.h"
#include "app/viewer/model/thumbnail.h"
#include "core/drawing/page_setup.h"
#include "tests/file_text.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

const glm::u8vec4 kRed(255, 0, 0, 255), kBlue(0, 0, 255, 255);

SmallPicture one_pixel(glm::u8vec4 colour) {
    SmallPicture picture(1, 1);
    picture.at(0, 0) = colour;
    return picture;
}

// Black at the left, white at the right.
SmallPicture half_black(int width, int height) {
    SmallPicture picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = x < width / 2 ? glm::u8vec4(0, 0, 0, 255) : glm::u8vec4(255);
    return picture;
}

// 800 wide, blue at the right.
void write_half_red(const fs::path& file, int height) {
    Grid<glm::u8vec3> picture(800, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 800; ++x) picture.at(x, y) = x < 400 ? kRed : kBlue;
    std::ofstream out(file, std::ios::binary);
    write_png(out, {.width = 800, .height = height}, [&](const PixelSink& sink) { sink(picture); });
}

std::string said_by(const std::string& command) {
    const Outcome outcome = run_in_shell(command);
    CHECK_MESSAGE(outcome.status == 0, command);
    return outcome.out;
}

std::string md5_of(const std::string& text) {
    return said_by("printf %s '" + text + "' | md5sum").substr(0, 32);
}

std::string time_of(const fs::path& file) {
    const std::string seconds = said_by("stat -c %Y '" + file.string() + "'");
    return seconds.substr(0, seconds.find('\n'));
}

}  // namespace

TEST_CASE("what is asked for is there after a while, and is made once") {
    SmallPictures pictures([] {});
    int made = 0;
    const auto red = [&](const std::stop_token&) { return ++made, one_pixel(kRed); };
    const auto blue = [](const std::stop_token&) { return one_pixel(kBlue); };
    CHECK(pictures.of("red", red) == nullptr);
    REQUIRE(wait_until([&] { return pictures.of("red", red) && pictures.of("blue", blue); }));
    CHECK(pictures.of("red", red)->at(0, 0) == kRed);
    CHECK(pictures.of("blue", blue)->at(0, 0) == kBlue);
    CHECK(made == 1);
    pictures.forget();
    CHECK(pictures.of("red", red) == nullptr);
    REQUIRE(wait_until([&] { return pictures.of("red", red); }));
    CHECK(made == 2);
}

TEST_CASE("an entry without a picture is empty, and keeps no other from its own") {
    SmallPictures pictures([] {});
    const SmallPictures::Make none = [](const std::stop_token&) -> SmallPicture {
        throw std::runtime_error("no picture");
    };
    const auto red = [](const std::stop_token&) { return one_pixel(kRed); };
    REQUIRE(wait_until([&] { return pictures.of("none", none) && pictures.of("red", red); }));
    CHECK(pictures.of("none", none)->empty());
}

TEST_CASE("a file's thumbnail is the picture, small, and another once the file is written anew") {
    const TemporaryFolder folder;
    write_half_red(folder / "a.png", 400);
    const SmallPicture small = thumbnail_of(folder / "a.png", "", {});
    CHECK(small.width == kLargeThumbnailSide);
    CHECK(small.width == 2 * small.height);
    CHECK(small.at(0, 0) == kRed);
    CHECK(small.at(small.width - 1, small.height - 1) == kBlue);

    const std::string key = thumbnail_key(folder / "a.png");
    CHECK(thumbnail_key(folder / "a.png") == key);
    write_half_red(folder / "a.png", 200);
    CHECK(thumbnail_key(folder / "a.png") != key);
    CHECK_THROWS_AS(thumbnail_of(folder / "none.png", "", {}), std::exception);
    CHECK(folder.entries() == 1);
}

TEST_CASE("thumbnails are kept as the standard says, for as long as the file stays what it is") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a b \xc3\xbc.png", kept = folder / "cache/thumbnails";
    const std::string uri = "file://" + folder.path().string() + "/a%20b%20%C3%BC.png";
    write_half_red(file, 400);
    const SmallPicture made = thumbnail_of(file, kept, {});
    const fs::path thumbnail = kept / "large" / (md5_of(uri) + ".png");
    CHECK(said_by("identify -format '%w %h %[Thumb::URI] %[Thumb::MTime]' '" + thumbnail.string() + "'") ==
          "256 128 " + uri + " " + time_of(file));
    CHECK(said_by("stat -c %a '" + thumbnail.string() + "'") == "600\n");
    for (const fs::path& private_folder : {kept / "large", kept, kept.parent_path()})
        CHECK(said_by("stat -c %a '" + private_folder.string() + "'") == "700\n");

    // The file is not read again while it is as old.
    const fs::file_time_type written = fs::last_write_time(file);
    put_text(file, "\x89PNG\r\n\x1a\n, and no more");
    fs::last_write_time(file, written);
    CHECK(thumbnail_of(file, kept, {}).values == made.values);
    fs::last_write_time(file, written + std::chrono::seconds(10));
    CHECK_THROWS_AS(thumbnail_of(file, kept, {}), std::exception);
    // That it is none is kept too.
    CHECK(thumbnail_of(file, kept, {}).empty());
    std::vector<std::string> failures;
    for (const auto& program : fs::directory_iterator(kept / "fail"))
        if (fs::exists(program / thumbnail.filename()))
            failures.push_back(program.path().filename().string());
    REQUIRE(failures.size() == 1);
    CHECK(failures.front().starts_with("dapple-"));

    write_half_red(file, 200);
    fs::last_write_time(file, written + std::chrono::seconds(20));
    CHECK(thumbnail_of(file, kept, {}).height == 64);
    // None are made of thumbnails.
    CHECK(thumbnail_of(thumbnail, kept, {}).width == 256);
    CHECK_FALSE(fs::exists(kept / "large" / (md5_of("file://" + thumbnail.string()) + ".png")));
}

TEST_CASE("a thumbnail that another program made is shown, unless the picture has changed since") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.png", kept = folder / "thumbnails";
    const std::string uri = "file://" + file.string();
    write_half_red(file, 400);
    for (const char* size : {"normal", "xx-large"}) {
        const auto put_lime = [&](const std::string& of, const std::string& time) {
            fs::create_directories(kept / size);
            said_by("oiiotool --create 128x64 3 --fill:color=0,1,0 128x64 -d uint8 --sattrib Thumb::URI '" +
                    of + "' --sattrib Thumb::MTime " + time + " -o '" +
                    (kept / size / (md5_of(uri) + ".png")).string() + "'");
        };
        put_lime(uri, time_of(file));
        CHECK(thumbnail_of(file, kept, {}).at(5, 5) == glm::u8vec4(0, 255, 0, 255));
        for (const auto& [of, time] :
             {std::pair(uri, std::string("1")), std::pair(uri + "x", time_of(file))}) {
            put_lime(of, time);
            CHECK(thumbnail_of(file, kept, {}).at(5, 5) == kRed);
            fs::remove_all(kept / "large");
        }
        fs::remove_all(kept);
    }
}

TEST_CASE("the preview of settings is their page: ink where the picture is dark, paper around it") {
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.placing.count = 5000;
    settings.ink = {1, 0, 0};
    settings.paper = {0, 0, 1};
    settings.page.paper = Paper::a4;
    settings.page.margins = {20, 20, 20, 20};
    const auto inked = [&] {
        const SmallPicture page =
            small_drawing(half_black(60, 60), settings, 297, {});  // a pixel a millimetre
        REQUIRE(page.height == 297);
        CHECK(page.width == 210);
        const glm::u8vec4 paper(glm::u8vec3(settings.paper * 255.0f), 255);
        CHECK(page.at(10, 10) == paper);
        CHECK(page.at(170, 148) == paper);
        int ink = 0;
        for (int y = 130; y < 170; ++y)
            for (int x = 40; x < 80; ++x) ink += page.at(x, y).b < 128;
        return ink / 1600.0;
    };
    SUBCASE("dots") {
        CHECK(inked() > 0.8);
    }
    SUBCASE("lines of a pen") {
        settings.style = DrawingStyle::line;
        settings.pen_width_mm = 2;
        CHECK(inked() > 0.8);
    }
    SUBCASE("several pens") {
        settings.pens.set = PenSet::own;
        settings.pens.own = {{.name = "Red", .colour = {1, 0, 0}, .width_mm = 2},
                             {.name = "Black", .colour = kBlack, .width_mm = 2}};
        settings.paper = kWhite;
        CHECK(inked() > 0.8);
    }
}

}  // namespace dapple
