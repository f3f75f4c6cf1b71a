#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "io/decoding/decoder_limits.h"
#include "io/decoding/decoder_process.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/png_chunk.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

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

std::string little_endian(std::uint32_t number) {
    const std::string bytes = big_endian(number);
    return {bytes.rbegin(), bytes.rend()};
}

// A header of 16-bit colours with alpha, and the beginning of the pixels: nothing, many times over.
std::string endless_png(std::uint32_t side, char interlaced) {
    const std::string header =
        big_endian(side) + big_endian(side) + std::string("\x10\6\0\0", 4) + interlaced;
    // Deflate's stored blocks.
    std::string pixels = "\x78\x01" + std::string("\0\0\x10\xff\xef", 5) + std::string(0x1000, '\0');
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", pixels);
}

// A header of three floats a pixel, uncompressed, and no pixels.
std::string endless_exr(std::uint32_t side) {
    const auto attribute = [](const char* name, const char* type, const std::string& value) {
        return std::string(name) + '\0' + type + '\0' +
               little_endian(static_cast<std::uint32_t>(value.size())) + value;
    };
    std::string channels;
    for (const char* const name : {"B", "G", "R"})
        channels += std::string(name) + '\0' + little_endian(2) + little_endian(0) + little_endian(1) +
                    little_endian(1);
    channels += '\0';
    const std::string box =
        little_endian(0) + little_endian(0) + little_endian(side - 1) + little_endian(side - 1);
    const std::string one = std::string("\0\0\x80\x3f", 4), zeros = std::string(8, '\0');
    return little_endian(20000630) + little_endian(2) + attribute("channels", "chlist", channels) +
           attribute("compression", "compression", std::string(1, '\0')) +
           attribute("dataWindow", "box2i", box) + attribute("displayWindow", "box2i", box) +
           attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", one) + attribute("screenWindowCenter", "v2f", zeros) +
           attribute("screenWindowWidth", "float", one) + std::string(1000, '\0');
}

}  // namespace

TEST_CASE("a decoder that crashes, stops or says nonsense is one sentence here") {
    CHECK(has(Decoder("kill -SEGV $$").sentence(), "its decoder crashed (Segmentation fault)"));
    CHECK(has(Decoder("kill -ABRT $$").sentence(), "its decoder crashed (Aborted)"));
    CHECK(has(Decoder("kill -XCPU $$").sentence(), "far longer to decode"));
    CHECK(has(Decoder("kill -TERM $$").sentence(), "its decoder was stopped"));
    CHECK(has(Decoder("exit 3").sentence(), "without an answer (exit 3)"));
    CHECK(has(Decoder("exit 127").sentence(), "the system does not load its decoder"));
    CHECK(has(Decoder("echo nonsense").sentence(), "sent nothing that can be understood"));
    // A header of 4 x 4 pixels, with two texts that are empty, and one row of it.
    CHECK(has(
        Decoder(
            R"(printf 'p\004\0\0\0\004\0\0\0\001\0\0\0\001\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0r0123012301230123')")
            .sentence(),
        "without an answer"));
    // A picture larger than was asked for.
    CHECK(has(Decoder(R"(printf 'p\0\0\0\100\0\0\0\100\001\0\0\0\001\0\0\0\0\0\0\0\0\0\0\0')").sentence(),
              "megapixels"));
    // A picture of no width.
    CHECK(has(Decoder(R"(printf 'p\0\0\0\0\0\0\0\0\001\0\0\0\001\0\0\0\0\0\0\0\0\0\0\0')").sentence(),
              "no picture"));
    CHECK(has(Decoder("sleep 0; exec 1>&-; sleep 1; kill -SEGV $$").sentence(), "crashed"));
}

TEST_CASE("what a decoder may use is limited") {
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        limit_decoder(kUsualPixels);
        int failed = 0;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        constexpr std::size_t kGigabyte = 1 << 30;
        const auto memory = [](std::size_t bytes) {
            return ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
                   MAP_FAILED;
        };
        if (memory(kGigabyte)) failed |= 1;
        limit_decoder_to({.in_memory = kGigabyte, .in_all = 60'000'000});
        if (!memory(kGigabyte)) failed |= 2;
        if (memory(3 * kGigabyte)) failed |= 4;
#endif
        std::signal(SIGXFSZ, SIG_IGN);
        const int file = ::open((folder / "written").c_str(), O_CREAT | O_WRONLY, 0600);
        if (::write(file, "x", 1) == 1) failed |= 8;
        rlimit seconds{};
        limit_decoder_to({.in_all = 60'000'000});
        if (::getrlimit(RLIMIT_CPU, &seconds) != 0 || seconds.rlim_cur < 60 || seconds.rlim_cur > 120)
            failed |= 16;
        // A picture that keeps its decoder busy for ever.
        const pid_t busy = ::fork();
        if (busy == 0) {
            limit_decoder(kUsualPixels);
            seconds.rlim_cur = 1;
            ::setrlimit(RLIMIT_CPU, &seconds);
            for (std::atomic<int> i = 0;; ++i) {
            }
        }
        int status = 0;
        ::waitpid(busy, &status, 0);
        if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGXCPU) failed |= 32;
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

TEST_CASE("a header that asks for gigabytes gets none, and a sentence says what is wrong") {
    const TemporaryFolder folder;
    const std::string psd =
        std::string("8BPS\0\1\0\0\0\0\0\0\0\3", 14) + std::string("\0\0\x75\x30\0\0\x75\x30\0\x08\0\3", 12);
    put_text(folder / "bomb.psd",
             psd + std::string("\0\0\0\0\x7f\xff\xff\xff\x7f\xff\xff\xff", 12) + std::string(500, '\0'));
    put_text(folder / "bomb.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n");
    put_text(folder / "bomb.pgm", "P5\n19000 19000\n255\nonly a few");
    // 19,000 x 19,000 pixels of 8 bytes, in rows and interlaced, and of 12 bytes.
    put_text(folder / "rows.png", endless_png(19'000, 0));
    put_text(folder / "interlaced.png", endless_png(19'000, 1));
    put_text(folder / "floats.exr", endless_exr(19'000));
    for (const char* const name :
         {"bomb.psd", "bomb.hdr", "bomb.pgm", "rows.png", "interlaced.png", "floats.exr"}) {
        CAPTURE(std::string(name));
        // In a process of its own, whose children's memory is theirs alone.
        const pid_t child = ::fork();
        if (child == 0) {
            rusage own{}, decoder{};
            ::getrusage(RUSAGE_SELF, &own);
            const std::string sentence = sentence_of(folder / name);
            ::getrusage(RUSAGE_CHILDREN, &decoder);
            // A child begins as its parent is, until it is a program of its own.
            constexpr long kMostKilobytes = 700'000;
            const bool modest = decoder.ru_maxrss < own.ru_maxrss + kMostKilobytes;
            ::_exit((sentence.empty() || has(sentence, "without an answer") ? 1 : 0) | (modest ? 0 : 2));
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        REQUIRE(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 0);
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

TEST_CASE("a pipe that nobody writes to is opened at once, and can be given up") {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe.png";
    run("mkfifo " + pipe.string());
    std::stop_source stop;
    std::atomic<bool> ended = false;
    std::string sentence;
    std::jthread reader([&] {
        Decoded sink;
        try {
            decode_file(pipe, {}, sink, stop.get_token());
        } catch (const DecodeError& error) {
            sentence = error.what();
        }
        ended = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    CHECK_FALSE(ended);
    stop.request_stop();
    const bool has_ended = wait_until([&] { return ended.load(); });
    CHECK(has_ended);
    // Or it would wait for ever.
    if (!has_ended) run("echo > " + pipe.string());
    reader.join();
    CHECK(sentence == "was not read to its end: it was stopped");
}

TEST_CASE("what comes through a pipe without an end is refused at its beginning, or at a bound") {
    CHECK(has(sentence_of("/dev/zero"), "it would have to be PNG, JPEG"));
    const TemporaryFolder folder;
    const std::string pipe = (folder / "pipe").string();
    run("mkfifo " + pipe);
    std::jthread writer(
        [&] { run(R"((printf '\211PNG\r\n\032\n'; cat /dev/zero) 2>/dev/null > )" + pipe + " || true"); });
    const Descriptor from(::open(pipe.c_str(), O_RDONLY)), to(::memfd_create("kept", 0));
    REQUIRE(from);
    CHECK_THROWS_WITH(
        keep_input(from.get(), to.get(), 1'000'000),
        "is longer than 1 megabytes, the most that is read from a pipe; save it as a file first");
    CHECK(::lseek(to.get(), 0, SEEK_END) <= 1'000'000);
}

TEST_CASE("nothing is waited for behind the end that a PNG or a WebP says it has") {
    const TemporaryFolder folder;
    write_picture(folder / "a.png",
                  {.width = 300, .height = 200, .values = std::vector<float>(60'000, 0.25f)});
    write_picture(folder / "a.webp",
                  {.width = 300, .height = 200, .channels = 3, .values = std::vector<float>(180'000, 0.25f)});
    const std::string pipe = (folder / "pipe").string();
    run("mkfifo " + pipe);
    for (const char* const name : {"a.png", "a.webp"}) {
        CAPTURE(std::string(name));
        const fs::path file = folder / name;
        Decoded through;
        {
            std::jthread writer([&] {
                run("(cat " + file.string() + "; cat /dev/zero) 2>/dev/null > " + pipe + " || true");
            });
            decode_file(pipe, {}, through);
        }
        CHECK(through.pixels == decoded(file).pixels);
        // The last byte is of the picture.
        const std::string bytes = text_of(file);
        const Descriptor to(::memfd_create("kept", 0));
        std::array<int, 2> ends{};
        REQUIRE(::pipe(ends.data()) == 0);
        const Descriptor from(ends[0]);
        for (const std::string& part : {bytes.substr(0, bytes.size() - 1), bytes.substr(bytes.size() - 1)})
            REQUIRE(::write(ends[1], part.data(), part.size()) == static_cast<ssize_t>(part.size()));
        ::close(ends[1]);
        keep_input(from.get(), to.get());
        CHECK(::lseek(to.get(), 0, SEEK_END) == static_cast<off_t>(bytes.size()));
    }
}

TEST_CASE("the true reason is said why what comes through a pipe cannot be kept") {
    const TemporaryFolder folder;
    // In a process of its own: what it does to limits lasts.
    const pid_t child = ::fork();
    if (child == 0) {
        std::array<int, 2> ends{};
        const Descriptor file(::open((folder / "kept").c_str(), O_RDWR | O_CREAT, 0600));
        std::string picture = "\x89PNG\r\n\x1a\n" + std::string(10'000, '\0');
        rlimit most{1000, 1000};
        if (::pipe(ends.data()) != 0 || ::write(ends[1], picture.data(), picture.size()) < 10'000 ||
            ::close(ends[1]) != 0 || ::setrlimit(RLIMIT_FSIZE, &most) != 0)
            ::_exit(2);
        try {
            keep_input(ends[0], file.get());
        } catch (const DecodeError& error) {
            ::_exit(has(error.what(), "cannot be kept while it is read: File too large") ? 0 : 3);
        }
        ::_exit(4);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("a picture that one may not read is told as such") {
    const TemporaryFolder folder;
    put_text(folder / "a.png", "text");
    fs::permissions(folder.path(), fs::perms::all);
    fs::permissions(folder / "a.png", fs::perms::none);
    const pid_t child = ::fork();
    if (child == 0) {
        // Nothing is forbidden to root.
        constexpr uid_t kNobody = 65534;
        if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(2);
        ::_exit(sentence_of(folder / "a.png") == "cannot be read: Permission denied" ? 0 : 3);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("where few files may be open the true reason is said, however few") {
    const TemporaryFolder folder;
    write_picture(folder / "a.png", {.width = 4, .height = 4, .values = std::vector<float>(16, 0.5f)});
    for (const rlim_t most : {4, 5, 6, 7, 8, 9, 10, 11, 12}) {
        CAPTURE(most);
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit few{most, most};
            ::setrlimit(RLIMIT_NOFILE, &few);
            const std::string sentence = sentence_of(folder / "a.png");
            const bool true_reason = has(sentence, "Too many open files") || has(sentence, "does not load");
            ::_exit(sentence.empty() || true_reason ? 0 : 3);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        REQUIRE(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 0);
    }
}

TEST_CASE("of a picture with an impossible size the size is told, whatever its library does with it") {
    const TemporaryFolder folder;
    const std::string rest(32, '\0');
    put_text(folder / "a.gif", "GIF89a\xff\xff\xff\xff\x80" + rest);
    CHECK(sentence_of(folder / "a.gif") == "65,535 x 65,535 pixels are over 400 megapixels");
    const auto bmp = [&](const std::string& size) {
        return "BM" + std::string("\x40\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0", 16) + size +
               std::string("\x01\0\x18\0", 4) + rest;
    };
    put_text(folder / "wide.bmp", bmp(std::string("\xff\xff\xff\x7f\x01\0\0\0", 8)));
    CHECK(sentence_of(folder / "wide.bmp") == "2,147,483,647 x 1 pixels are over 400 megapixels");
    // Within the number of pixels, but a row takes gigabytes.
    put_text(folder / "long.bmp", bmp(std::string("\x00\x84\xd7\x17\x01\0\0\0", 8)));
    CHECK(sentence_of(folder / "long.bmp") ==
          "has 400,000,000 x 1 pixels, where a side has at most 1,000,000");
    // From the top down.
    put_text(folder / "high.bmp", bmp(std::string("\x01\0\0\0\x01\0\0\x80", 8)));
    CHECK(sentence_of(folder / "high.bmp") == "1 x 2,147,483,647 pixels are over 400 megapixels");
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
