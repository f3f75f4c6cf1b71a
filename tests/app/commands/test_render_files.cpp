// dapple render: the pictures it reads or refuses, and what becomes of an old drawing when saving fails.

#include <doctest/doctest.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tests/child_process.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/places.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

namespace {

std::string half_of(const std::filesystem::path& file) {
    const std::string whole = text_of(file);
    return whole.substr(0, whole.size() / 2);
}

}  // namespace

TEST_CASE("pictures that cannot be read are refused in a sentence, and an old drawing stays") {
    const Scene scene;
    const auto refused = [&](const std::string& name, const std::string& words) {
        scene.must_fail("render " + scene(name) + " -o " + scene("old.svg"), name + ": " + words);
    };
    put_text(scene("empty.png"), "");
    put_text(scene("text.jpg"), "No picture, but a sentence.\n");
    PictureFile photo{.width = 200, .height = 200};
    for (int i = 0; i < 40'000; ++i) photo.values.push_back(static_cast<float>(i * 7919 % 1000) / 999);
    write_picture(scene("whole.jpg"), photo);
    write_picture(scene("whole.png"), photo);
    put_text(scene("half.jpg"), half_of(scene("whole.jpg")));
    put_text(scene("half.png"), half_of(scene("whole.png")));
    put_text(scene("large.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 40000\n");
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    write_picture(scene("nan.exr"), {.width = 2, .values = {0, nan}, .type = "float"});
    write_picture(scene("infinite.exr"), {.width = 2, .values = {infinity, 0}, .type = "float"});
    write_picture(scene("white.png"), {.width = 9, .height = 9, .values = std::vector<float>(81, 1.0f)});
    write_picture(scene("clear.png"),
                  {.width = 9, .height = 9, .channels = 4, .values = std::vector<float>(324, 0.0f)});

    refused("none.png", "no such file");
    refused("", "is a folder");
    refused("empty.png", "the file is empty");
    refused("text.jpg", "not a picture");
    refused("half.jpg", "the picture is damaged");
    refused("half.png", "the picture is damaged");
    // OpenImageIO from 3 on sees by itself that there is not enough of it.
    const std::string large = run_dapple("render " + scene("large.hdr") + " -o " + scene("old.svg")).err;
    refused("large.hdr", large.find("claims") == large.npos ? "40,000 x 30,000 pixels are over 400 megapixels"
                                                            : "not a picture that can be read");
    refused("nan.exr", "pixel 1, 0 is not a number");
    refused("infinite.exr", "pixel 0, 0 is infinite");
    refused("white.png", "nothing to draw");
    refused("clear.png", "nothing to draw");
}

TEST_CASE("pictures that are odd but whole are drawn") {
    const Scene scene;
    const auto drawn = [&](const std::string& name, const std::string& options = "--dots 100") {
        const Outcome outcome =
            run_dapple("render " + scene(name) + " -o " + scene("odd.svg") + " " + options);
        CAPTURE(name);
        REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
        return read_svg(scene("odd.svg")).circles().size();
    };
    write_picture(scene("1x1.png"), {.values = {0.25f}});
    write_picture(scene("1x10000.png"),
                  {.width = 1, .height = 10'000, .values = std::vector<float>(10'000, 0.5f)});
    write_picture(scene("black.png"), {.width = 9, .height = 9, .values = std::vector<float>(81, 0.0f)});
    write_picture(scene("white.png"), {.width = 9, .height = 9, .values = std::vector<float>(81, 1.0f)});
    PictureFile deep = test_picture();
    deep.type = "uint16";
    write_picture(scene("deep.tif"), deep);
    const std::string convert = "convert " + scene("cat.png") + " -fill red -draw 'rectangle 0,0 20,20' ";
    REQUIRE(run_in_shell(convert + "-type Palette PNG8:" + scene("palette.png")).status == 0);
    REQUIRE(run_in_shell(convert + "-colorspace CMYK " + scene("cmyk.jpg")).status == 0);
    scene.must_fail(
        "render " + scene("1x10000.png") + " -o " + scene("old.svg"),
        "1x10000.png: 1 x 10000 pixels would make a page 200 mm wide and 2000 m high, and 100 m is "
        "the most; choose a --width of 9.5 or less");
    CHECK(drawn("1x10000.png", "--dots 100 --width 9.5") == 100);
    for (const char* name : {"1x1.png", "black.png", "deep.tif", "palette.png", "cmyk.jpg"}) {
        CHECK(drawn(name) == 100);
    }
    // Asked for by scale, white paper has no dots, and that is a drawing too.
    CHECK(drawn("white.png", "--scale 1000") == 0);
}

TEST_CASE("settings and templates that cannot be read are refused with the true reason") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o " + scene("old.gcode");
    std::filesystem::create_directory(scene("folder.png"));
    std::filesystem::create_symlink(scene("loop.svg"), scene("loop.svg"));
    scene.must_fail(from + " --settings-from " + scene("folder.png"), "folder.png: is a folder, not a file");
    scene.must_fail(from + " --settings-from " + scene("none.svg"), "none.svg: no such file");
    for (const char* option : {" --settings-from ", " --gcode ", " --tile ", " --mask "})
        scene.must_fail(from + option + scene("loop.svg"), "loop.svg: ");
    put_text(scene("zeros"), std::string(100, '\0'));
    for (const char* option : {" --gcode ", " --pens ", " --tile "})
        scene.must_fail(from + option + scene("zeros"), "zeros: is not text in UTF-8");
}

TEST_CASE("drawings that cannot be saved are refused in a sentence") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o ";
    scene.must_fail(from + scene("missing/a.svg"), "/missing does not exist");
    scene.must_fail(from + scene("cat.png/a.svg"), "is a file, not a folder");
    scene.must_fail(from + scene("old.bmp"), "must end in .svg, .pdf, .png, .tif");
    scene.must_fail(from + scene("old"), "must end in .svg, .pdf, .png, .tif");
    scene.must_fail(from + scene("./cat.png"), "would be written over the picture");
    scene.must_fail(from + scene("old.svg") + " --stats " + scene("./old.svg"),
                    "would be written over the drawing");
    scene.must_fail(from + scene("old.svg") + " --stats " + scene("./cat.png"),
                    "would be written over the picture");
    scene.must_fail(from + scene("cat.png"), "would be written over the picture");
    scene.must_fail(from + scene("old.svg") + " --stats " + scene("missing/s.json"),
                    "/missing does not exist");
    std::filesystem::create_directory(scene("folder.svg"));
    scene.must_fail(from + scene("folder.svg"), "is a folder");
    scene.must_fail("render " + scene("cat.png"), "--output");
    // The drawing outgrows what a file may have here; 512 bytes a block.
    const Outcome limited = run_in_shell("ulimit -f 100; exec \"$DAPPLE\" " + from + scene("old.svg"));
    CAPTURE(limited.err);
    CHECK(limited.status == 1);
    CHECK(limited.sentences() == 1);
    CHECK(limited.err.find("old.svg: cannot be written") != std::string::npos);
    CHECK(text_of(scene("old.svg")) == "the old drawing");
}

TEST_CASE("a full or read-only disk is said, the old drawing stays, and nothing is left behind") {
    // A file system of our own, seen by this shell alone.
    const std::string own = run_in_shell("unshare --mount true").status == 0
                                ? "unshare --mount"
                                : "unshare --user --map-root-user --mount";
    if (run_in_shell(own + " sh -c 'mount -t tmpfs none /mnt'").status != 0) {
        MESSAGE("SKIPPED: not allowed to mount a small disk here");  // told to ctest
        return;
    }
    const Scene scene;
    const std::string disk = scene("disk");
    std::filesystem::create_directory(disk);
    const auto on_disk = [&](const std::string& name, const std::string& before) {
        put_text(scene("script"), "mount -t tmpfs -o size=64k none " + disk + " && cd " + disk +
                                      " && printf old >a.svg && printf old >a.png && " + before +
                                      " || exit 99\n\"$DAPPLE\" render " + scene("cat.png") + " -o " + name +
                                      "\necho status $?, $(cat " + name + "), $(ls -A | wc -l) files\n");
        return run_in_shell(own + " sh " + scene("script"));
    };
    for (const std::string name : {"a.svg", "a.png"}) {
        const Outcome full = on_disk(name, "head -c 40000 /dev/zero >filler");
        CAPTURE(full.err);
        CHECK(full.out == "status 1, old, 3 files\n");
        CHECK(full.err == "dapple: " + name + ": cannot be written: the disk is full\n");
    }
    const Outcome read_only = on_disk("a.svg", "mount -o remount,ro " + disk);
    CAPTURE(read_only.err);
    CHECK(read_only.out == "status 1, old, 2 files\n");
    CHECK(read_only.err == "dapple: a.svg: is read-only; choose another name\n");
    const Outcome new_file = on_disk("b.svg", "printf old >b.svg && rm b.svg && mount -o remount,ro " + disk);
    CHECK(new_file.err.starts_with("dapple: b.svg: the folder . is read-only; choose another\n"));
}

// Whether a program holds a file open whose name is gone, or that never had one.
static bool has_nameless_file(pid_t program) {
    std::error_code ended;
    for (const auto& entry :
         std::filesystem::directory_iterator("/proc/" + std::to_string(program) + "/fd", ended)) {
        const std::string file = std::filesystem::read_symlink(entry.path(), ended).native();
        if (file.find("/#") != file.npos && file.ends_with(" (deleted)")) return true;
    }
    return false;
}

TEST_CASE("Ctrl+C while saving leaves the old drawing and nothing else") {
    const Scene scene;
    write_picture(scene("black.png"), {.width = 64, .height = 64, .values = std::vector<float>(4096, 0.0f)});
    const std::size_t before = scene.folder.entries();
    ChildProcess render({dapple_program(), "render", scene("black.png"), "-o", scene("old.svg"), "--dots",
                         "1000000", "--relax", "0"});
    // What is written so far lies beside the old drawing, or has no name yet.
    REQUIRE(render.brings([&] { return scene.folder.entries() > before || has_nameless_file(render.id()); }));
    render.send(SIGINT);
    CHECK(render.wait() == 128 + SIGINT);
    CHECK(text_of(scene("old.svg")) == "the old drawing");
    CHECK(scene.folder.entries() == before);
}

TEST_CASE("a reader that leaves the pipe it is given ends in a sentence, not in silence") {
    const Scene scene;
    const std::string pipe = scene("drawing.svg");
    const Outcome left =
        run_in_shell("mkfifo " + pipe + "; head -c 100 " + pipe + " >/dev/null & exec \"$DAPPLE\" render " +
                     scene("cat.png") + " -o " + pipe);
    CHECK(left.status == 1);
    CHECK(left.err ==
          "dapple: " + pipe + ": cannot be written: the program that read it has ended or stopped reading\n");
}

TEST_CASE("names that would command a terminal or end a line are written out") {
    const Scene scene;
    const std::string name = scene("two\nlines \x1b[2J \xff.png");
    const Outcome missing = run_dapple("render '" + name + "' -o " + scene("a.svg"));
    CHECK(missing.status == 1);
    CHECK(missing.sentences() == 1);
    CHECK(missing.err.find("two\\nlines \\x1b[2J \\xff.png: ") != std::string::npos);
    CHECK(missing.err.find('\x1b') == std::string::npos);
    // Options and figures too.
    const Outcome option = run_dapple("render -o " + scene("a.svg") + " --tile '\x1b]0;mine\x07'");
    CHECK(option.err.starts_with("dapple: \\x1b]0;mine\\x07: no such tile"));
    std::filesystem::copy_file(scene("cat.png"), name);
    REQUIRE(run_dapple("render '" + name + "' -o " + scene("a.svg") + " --stats " + scene("s.json")).status ==
            0);
    const std::string image = read_json(scene("s.json"))["image"];
    CHECK(image.find("two\nlines \x1b[2J ") != image.npos);
}
