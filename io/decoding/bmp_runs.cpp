#include "io/decoding/bmp_runs.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "io/decoding/decoded_image.h"

namespace dapple {
namespace {

using Bytes = std::vector<unsigned char>;

// Places in a file, and what is there.
constexpr std::size_t kBegin = 10, kHeaderSize = 14, kWidth = 18, kHeight = 22, kBits = 28, kCompression = 30,
                      kSize = 34, kColours = 46, kHeader = 54;
constexpr std::uint32_t kRuns8 = 1, kRuns4 = 2;

std::uint32_t number_at(std::span<const unsigned char> bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 4; i-- > 0;) number = number << 8 | bytes[at + i];
    return number;
}

void put_number(Bytes& bytes, std::size_t at, std::uint32_t number) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<unsigned char>(number >> 8 * i);
}

Bytes whole(int file) {
    struct stat status {};
    if (::fstat(file, &status) != 0 || status.st_size <= 0) return {};
    Bytes bytes(static_cast<std::size_t>(status.st_size));
    std::size_t read = 0;
    while (read < bytes.size()) {
        const ssize_t got = ::pread(file, bytes.data() + read, bytes.size() - read, static_cast<off_t>(read));
        if (got <= 0) break;
        read += static_cast<std::size_t>(got);
    }
    bytes.resize(read);
    return bytes;
}

[[noreturn]] void fail() {
    throw DecodeError("the picture is damaged (its runs do not fit its size)");
}

// Rows of pixels, in the order of the file; those that no run reaches have the first colour.
class Rows {
 public:
    Rows(std::size_t width, std::size_t height)
        : width_(width), height_(height), row_bytes_((width + 3) / 4 * 4), pixels_(row_bytes_ * height) {}

    // What lies beyond the end of a row is cut off.
    void put(unsigned char pixel) {
        if (y_ >= height_) fail();
        if (x_ < width_) pixels_[y_ * row_bytes_ + x_] = pixel;
        ++x_;
    }
    void end_line() { x_ = 0, ++y_; }
    void jump(std::size_t right, std::size_t on) { x_ += right, y_ += on; }
    bool complete() const { return y_ >= height_; }
    const Bytes& pixels() const { return pixels_; }

 private:
    std::size_t width_, height_, row_bytes_, x_ = 0, y_ = 0;
    Bytes pixels_;
};

void read_runs(std::span<const unsigned char> runs, bool nibbles, Rows& rows) {
    constexpr unsigned char kEndOfLine = 0, kEnd = 1, kJump = 2;
    const auto half = [](unsigned char byte, std::size_t i) {
        return static_cast<unsigned char>(i % 2 == 0 ? byte >> 4 : byte & 15);
    };
    std::size_t at = 0;
    const auto next = [&] {
        if (at >= runs.size()) fail();
        return runs[at++];
    };
    while (at < runs.size()) {
        const unsigned char count = next(), what = next();
        if (count > 0) {
            for (std::size_t i = 0; i < count; ++i) rows.put(nibbles ? half(what, i) : what);
        } else if (what == kEndOfLine) {
            rows.end_line();
        } else if (what == kEnd) {
            return;
        } else if (what == kJump) {
            const std::size_t right = next(), on = next();
            rows.jump(right, on);
        } else {  // so many pixels as they are, in a whole number of two bytes
            const std::size_t bytes = nibbles ? (what + std::size_t{1}) / 2 : what;
            for (std::size_t i = 0; i < bytes; ++i) {
                const unsigned char byte = next();
                if (!nibbles) rows.put(byte);
                for (std::size_t k = 0; nibbles && k < 2 && 2 * i + k < what; ++k) rows.put(half(byte, k));
            }
            if (bytes % 2 != 0) next();
        }
    }
    if (!rows.complete()) fail();
}

}  // namespace

std::optional<std::vector<unsigned char>> bmp_without_runs(int file) {
    std::array<unsigned char, kHeader> header{};
    if (::pread(file, header.data(), header.size(), 0) != static_cast<ssize_t>(header.size()) ||
        number_at(header, kHeaderSize) < kHeader - kHeaderSize)
        return std::nullopt;
    const std::uint32_t compression = number_at(header, kCompression);
    if (compression != kRuns8 && compression != kRuns4) return std::nullopt;
    const Bytes bytes = whole(file);
    const std::size_t begin = number_at(header, kBegin);
    const std::int64_t width = static_cast<std::int32_t>(number_at(header, kWidth)),
                       height = static_cast<std::int32_t>(number_at(header, kHeight));
    if (begin < kHeader || begin > bytes.size() || width <= 0 || height == 0) fail();
    Rows rows(static_cast<std::size_t>(width), static_cast<std::size_t>(std::abs(height)));
    read_runs(std::span(bytes).subspan(begin), compression == kRuns4, rows);

    Bytes plain(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(begin));
    plain[kBits] = 8;
    put_number(plain, kCompression, 0);
    put_number(plain, kSize, static_cast<std::uint32_t>(rows.pixels().size()));
    if (compression == kRuns4 && number_at(plain, kColours) == 0) put_number(plain, kColours, 16);
    plain.insert(plain.end(), rows.pixels().begin(), rows.pixels().end());
    return plain;
}

}  // namespace dapple
