#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "app/decoding/decoder_limits.h"
#include "app/decoding/decoder_process.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

struct Decoded : ImageSink {
    void begin(const ImageHeader& given) override { header = given; }
    void row(std::span<const glm::vec3> colours) override {
        pixels.insert(pixels.end(), colours.begin(), colours.end());
    }
    ImageHeader header;
    std::vector<glm::vec3> pixels;
};

Decoded decoded(const fs::path& path, const DecodeRequest& request = {}) {
    Decoded sink;
    decode_file(path, request, sink);
    return sink;
}

std::string sentence_of(const fs::path& path, const DecodeRequest& request = {}) {
    try {
        decoded(path, request);
    } catch (const DecodeError& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

// A decoder that does what a shell is told.
class Decoder {
 public:
    explicit Decoder(const std::string& commands) {
        put_text(folder_ / "decoder", "#!/bin/sh\n" + commands + "\n");
        fs::permissions(folder_ / "decoder", fs::perms::owner_all);
        write_picture(folder_ / "whole.png",
                      {.width = 4, .height = 4, .values = std::vector<float>(16, 0.5f)});
    }

    std::string sentence() const {
        Decoded sink;
        try {
            decode_file_by(folder_ / "decoder", folder_ / "whole.png", {}, sink);
        } catch (const DecodeError& error) {
            return error.what();
        }
        return "";
    }

 private:
    TemporaryFolder folder_;
};

void run(const std::string& command) {
    REQUIRE_MESSAGE(std::system(command.c_str()) == 0, command);
}

}  // namespace

TEST_CASE("a decoder that crashes, stops or says nonsense is one sentence here") {
    CHECK(has(Decoder("kill -SEGV $$").sentence(), "its decoder crashed (Segmentation fault)"));
    CHECK(has(Decoder("kill -ABRT $$").sentence(), "its decoder crashed (Aborted)"));
    CHECK(has(Decoder("kill -XCPU $$").sentence(), "far longer to decode"));
    CHECK(has(Decoder("kill -TERM $$").sentence(), "its decoder was stopped"));
    CHECK(has(Decoder("exit 3").sentence(), "without a word (exit 3)"));
    CHECK(has(Decoder("echo nonsense").sentence(), "says nothing that can be understood"));
    // A header of 4 x 4 pixels and one row of it.
    CHECK(
        has(Decoder(R"(printf 'p\004\0\0\0\004\0\0\0\001\0\0\0\001\0\0\0\0\0\0\0\0\0\0\0r0123456789abcdef')")
                .sentence(),
            "without a word"));
    // A picture larger than was asked for.
    CHECK(has(Decoder(R"(printf 'p\0\0\0\100\0\0\0\100\001\0\0\0\001\0\0\0\0\0\0\0\0\0\0\0')").sentence(),
              "megapixels"));
    // A picture of no width.
    CHECK(has(Decoder(R"(printf 'p\0\0\0\0\0\0\0\0\001\0\0\0\001\0\0\0\0\0\0\0\0\0\0\0')").sentence(),
              "no picture"));
    CHECK(has(Decoder("sleep 0; exec 1>&-; sleep 1; kill -SEGV $$").sentence(), "crashed"));
}

TEST_CASE("what a decoder may use is limited") {
    const pid_t child = ::fork();
    if (child == 0) {
        limit_decoder();
        const TemporaryFolder folder;
        int failed = 0;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        constexpr std::size_t kGigabyte = 1 << 30;
        const auto memory = [](std::size_t bytes) {
            return ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
                   MAP_FAILED;
        };
        if (memory(kGigabyte)) failed |= 1;
        limit_decoder_to(kGigabyte);
        if (!memory(kGigabyte)) failed |= 2;
        if (memory(3 * kGigabyte)) failed |= 4;
#endif
        std::signal(SIGXFSZ, SIG_IGN);
        const int file = ::open((folder / "written").c_str(), O_CREAT | O_WRONLY, 0600);
        if (::write(file, "x", 1) == 1) failed |= 8;
        ::_exit(failed);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("what a file is decides its content, not its name") {
    const TemporaryFolder folder;
    write_picture(folder / "a.png", {.width = 8, .height = 8, .values = std::vector<float>(64, 1.0f)});
    write_picture(folder / "a.tif", {.width = 8, .height = 8, .values = std::vector<float>(64, 1.0f)});
    fs::rename(folder / "a.png", folder / "png.null");
    fs::rename(folder / "a.tif", folder / "tiff.jpg");
    CHECK(decoded(folder / "png.null").pixels.size() == 64);
    CHECK(decoded(folder / "tiff.jpg").pixels.size() == 64);
    // Pictures that are made up from a name.
    put_text(folder / "x.null", "");
    CHECK(sentence_of(folder / "x.null") == "the file is empty");
    CHECK(sentence_of("bw.null?RES=1024x1024") == "no such file");
    put_text(folder / "list.jpg", std::string("FOR4\0\0\0\4CIMG", 12) + std::string(1000, '\1'));
    CHECK(has(sentence_of(folder / "list.jpg"), "it would have to be PNG, JPEG"));
}

TEST_CASE("a header that asks for gigabytes gets none") {
    const TemporaryFolder folder;
    const std::string psd =
        std::string("8BPS\0\1\0\0\0\0\0\0\0\3", 14) + std::string("\0\0\x75\x30\0\0\x75\x30\0\x08\0\3", 12);
    put_text(folder / "bomb.psd",
             psd + std::string("\0\0\0\0\x7f\xff\xff\xff\x7f\xff\xff\xff", 12) + std::string(500, '\0'));
    put_text(folder / "bomb.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n");
    put_text(folder / "bomb.pgm", "P5\n19000 19000\n255\nonly a few");
    for (const char* const name : {"bomb.psd", "bomb.hdr", "bomb.pgm"}) {
        const std::string sentence = sentence_of(folder / name);
        CAPTURE(std::string(name));
        CAPTURE(sentence);
        CHECK(!sentence.empty());
    }
}

TEST_CASE("the true reason is said why a file cannot be read") {
    const TemporaryFolder folder;
    put_text(folder / "file", "text");
    CHECK(sentence_of(folder / "none.png") == "no such file");
    CHECK(sentence_of(folder / "file" / "a.png") == "cannot be read: Not a directory");
    fs::create_symlink(folder / "loop", folder / "loop");
    CHECK(has(sentence_of(folder / "loop"), "Too many levels of symbolic links"));
    CHECK(sentence_of(folder.path()) == "is a folder, not a picture");
    CHECK(sentence_of("/dev/null") == "the file is empty");
}

TEST_CASE("a picture may come through a pipe") {
    const TemporaryFolder folder;
    write_picture(folder / "a.jpg",
                  {.width = 200, .height = 100, .values = std::vector<float>(20'000, 0.5f)});
    write_picture(folder / "a.png",
                  {.width = 200, .height = 100, .values = std::vector<float>(20'000, 0.5f)});
    for (const char* const name : {"a.jpg", "a.png"}) {
        const std::string pipe = (folder / "pipe").string();
        run("mkfifo " + pipe);
        std::jthread writer([&] { run("cat " + (folder / name).string() + " > " + pipe); });
        CHECK(decoded(pipe).pixels.size() == 20'000);
        fs::remove(pipe);
    }
}

TEST_CASE("PNG read with libpng is what OpenImageIO reads") {
    const TemporaryFolder folder;
    std::vector<float> values;
    for (int i = 0; i < 37 * 23 * 4; ++i) values.push_back(static_cast<float>(i * 7919 % 1000) / 999.0f);
    for (const char* const type : {"uint8", "uint16"}) {
        for (int channels = 1; channels <= 4; ++channels) {
            write_picture(folder / ("c" + std::to_string(channels) + type + ".png"),
                          {.width = 37,
                           .height = 23,
                           .channels = channels,
                           .values = {values.begin(), values.begin() + 37 * 23 * channels},
                           .type = type});
        }
    }
    write_picture(folder / "linear.png", {.width = 37,
                                          .height = 23,
                                          .values = {values.begin(), values.begin() + 37 * 23},
                                          .colour_space = "linear"});
    const std::string from = "convert " + (folder / "c3uint8.png").string(),
                      to = " " + folder.path().string();
    run(from + " -interlace PNG" + to + "/interlaced.png");
    run("convert " + (folder / "c2uint16.png").string() + " -interlace PNG" + to + "/interlaced16.png");
    run(from + " -type Palette PNG8:" + folder.path().string() + "/palette.png");
    run(from + " -colors 2 -transparent '#808080' PNG8:" + folder.path().string() + "/transparent.png");
    for (const char* const depth : {"1", "2", "4"})
        run(from + " -colorspace Gray -depth " + depth + to + "/grey" + depth + ".png");
    run(from + " -define png:exclude-chunk=sRGB -gamma 1.7" + to + "/gamma.png");

    int files = 0;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        CAPTURE(entry.path());
        const std::string name = entry.path().filename().string();
        const bool has_alpha = name.starts_with("c2") || name.starts_with("c4") || name == "transparent.png";
        for (const bool over_paper : {true, false}) {
            if (!over_paper && !has_alpha) continue;
            const DecodeRequest request{.over_paper = over_paper};
            Decoded other;
            decode_file_by(decoder_for(PictureFormat::jpeg), entry.path(), request, other);
            const Decoded ours = decoded(entry.path(), request);
            CHECK(ours.header.width == 37);
            CHECK(ours.header.grey == other.header.grey);
            REQUIRE(ours.pixels.size() == other.pixels.size());
            double worst = 0;
            for (std::size_t i = 0; i < ours.pixels.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    worst = std::max(worst,
                                     static_cast<double>(std::abs(ours.pixels[i][c] - other.pixels[i][c])));
            // OpenImageIO rounds the exponent of a gamma to two digits.
            CHECK(worst < (name == "gamma.png" ? 2e-3 : 1e-4));
        }
        ++files;
    }
    CHECK(files == 17);
}

TEST_CASE("a camera's way of being held is read from a PNG") {
    const TemporaryFolder folder;
    const std::string png = (folder / "held.png").string();
    write_picture(folder / "held.tif",
                  {.width = 3, .height = 2, .values = {0, 0, 0, 1, 1, 1}, .orientation = 6});
    run("oiiotool " + (folder / "held.tif").string() + " -o " + png);
    Decoded other;
    decode_file_by(decoder_for(PictureFormat::jpeg), png, {}, other);
    CHECK(decoded(png).header.orientation == other.header.orientation);
}

TEST_CASE("the program links no OpenImageIO") {
    const Outcome libraries = run_in_shell("ldd \"$DAPPLE\"");
    CHECK(libraries.status == 0);
    CHECK(has(libraries.out, "libpng"));
    CHECK_FALSE(has(libraries.out, "OpenImageIO"));
}
