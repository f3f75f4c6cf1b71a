#include "io/decoding/psd_picture.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

#include "io/decoding/decoded_image.h"

namespace dapple {
namespace {

constexpr std::uint64_t kWholeHeader = 26;

[[noreturn]] void fail_at_row(int y) {
    throw DecodeError("the picture is damaged (row " + std::to_string(y) + " is not there)");
}

// Of runs, as PackBits has them; false if they do not fill the row just so far as it is long.
bool unpack(const std::vector<unsigned char>& packed, std::vector<unsigned char>& row) {
    std::size_t at = 0, to = 0;
    while (at < packed.size() && to < row.size()) {
        const auto what = static_cast<signed char>(packed[at++]);
        if (what == -128) continue;
        const std::size_t count = what < 0 ? std::size_t(1 - what) : std::size_t(what) + 1;
        if (to + count > row.size() || at + (what < 0 ? 1 : count) > packed.size()) return false;
        if (what < 0)
            std::fill_n(row.begin() + static_cast<long>(to), count, packed[at++]);
        else
            std::copy_n(packed.begin() + static_cast<long>(at), count, row.begin() + static_cast<long>(to));
        if (what >= 0) at += count;
        to += count;
    }
    return to == row.size();
}

}  // namespace

PsdPicture::PsdPicture(int file) : file_(file) {
    constexpr std::uint64_t kLargestBeginning = 256 << 20;
    constexpr int kGrey = 1, kRgb = 3, kDuotone = 8;
    if (number_in_file(file_, 4, 2) == 2) long_bytes_ = 8;  // of over 2 gigabytes, or 30,000 pixels a side
    channels_ = static_cast<int>(number_in_file(file_, 12, 2));
    height_ = static_cast<int>(std::min<std::uint64_t>(number_in_file(file_, 14, 4), INT32_MAX));
    width_ = static_cast<int>(std::min<std::uint64_t>(number_in_file(file_, 18, 4), INT32_MAX));
    bits_ = static_cast<int>(number_in_file(file_, 22, 2));
    const auto mode = static_cast<int>(number_in_file(file_, 24, 2));
    const std::uint64_t resources = kWholeHeader + 4 + number_in_file(file_, kWholeHeader, 4);
    layers_ = resources + 4 + number_in_file(file_, resources, 4);
    data_ = layers_ + static_cast<std::uint64_t>(long_bytes_) + number_in_file(file_, layers_, long_bytes_);
    std::array<char, 2> way{};
    if (layers_ > kLargestBeginning || data_ > INT64_MAX ||
        ::pread(file_, way.data(), way.size(), static_cast<off_t>(data_)) != 2)
        throw DecodeError("the picture is damaged (it ends before its pixels)");
    packed_ = way[1] == 1;
    colours_ = mode == kRgb ? 3 : mode == kGrey || mode == kDuotone ? 1 : 0;
    transparent_ = colours_ > 0 && channels_ > colours_ && way[0] == 0 && way[1] <= 1 &&
                   (bits_ == 8 || bits_ == 16 || bits_ == 32) && says_transparent();
}

std::vector<unsigned char> PsdPicture::beginning() const {
    std::vector<unsigned char> bytes(layers_);
    for (std::size_t read = 0; read < bytes.size();) {
        const ssize_t got =
            ::pread(file_, bytes.data() + read, bytes.size() - read, static_cast<off_t>(read));
        if (got <= 0) throw DecodeError("the picture is damaged (it ends before its pixels)");
        read += static_cast<std::size_t>(got);
    }
    bytes.resize(bytes.size() + static_cast<std::size_t>(long_bytes_));
    return bytes;
}

// The first channel after the colours is transparency if the number of layers is below 0. Of 16 and 32 bits,
// layers lie in a block of their own, behind the masks; without layers another one says so.
bool PsdPicture::says_transparent() const {
    const auto long_bytes = static_cast<std::uint64_t>(long_bytes_);
    const auto below_zero = [this](std::uint64_t at) { return (number_in_file(file_, at, 2) & 0x8000) != 0; };
    std::uint64_t at = layers_ + long_bytes;
    if (at == data_) return false;
    const std::uint64_t layers = number_in_file(file_, at, long_bytes_);
    at += long_bytes;
    if (layers > 0 && below_zero(at)) return true;
    at += layers;
    at += 4 + number_in_file(file_, at, 4);
    for (constexpr std::uint64_t kBlock = 12; at < data_ && data_ - at >= kBlock;) {
        std::array<char, 8> begin{};
        if (::pread(file_, begin.data(), begin.size(), static_cast<off_t>(at)) != 8) return false;
        const std::string_view mark(begin.data(), 4), key(begin.data() + 4, 4);
        if (mark != "8BIM" && mark != "8B64") return false;
        if (key == "Mtrn" || key == "Mt16" || key == "Mt32") return true;
        const bool is_layers = key == "Lr16" || key == "Lr32" || key == "Layr";
        constexpr std::array<std::string_view, 7> kLong{"LMsk", "Alph", "FMsk", "lnk2",
                                                        "FEid", "FXid", "PxSD"};
        const bool is_long = long_bytes_ == 8 && (is_layers || std::ranges::find(kLong, key) != kLong.end());
        const int bytes = is_long ? 8 : 4;
        const std::uint64_t size = number_in_file(file_, at + 8, bytes);
        at += 8 + static_cast<std::uint64_t>(bytes);
        if (is_layers && below_zero(at)) return true;
        if (size > data_ - std::min(at, data_)) return false;
        at += (size + 3) / 4 * 4;
    }
    return false;
}

void PsdPicture::find_rows() {
    const auto row_bytes = static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(bits_ / 8);
    const auto height = static_cast<std::size_t>(height_);
    const std::size_t count = height * static_cast<std::size_t>(channels());
    std::uint64_t at = data_ + 2;
    row_.resize(row_bytes);
    rows_.reserve(count + 1);
    if (!packed_) {
        for (std::size_t i = 0; i <= count; ++i) rows_.push_back(at + i * row_bytes);
        return;
    }
    const auto length_bytes = static_cast<std::size_t>(long_bytes_ / 2);
    std::vector<unsigned char> lengths(height * length_bytes);
    const std::uint64_t table = at;
    at += lengths.size() * static_cast<std::uint64_t>(channels_);
    rows_.push_back(at);
    for (int channel = 0; channel < channels(); ++channel) {
        if (::pread(file_, lengths.data(), lengths.size(),
                    static_cast<off_t>(table + lengths.size() * static_cast<std::uint64_t>(channel))) !=
            static_cast<ssize_t>(lengths.size()))
            fail_at_row(0);
        for (std::size_t y = 0; y < height; ++y) {
            std::uint64_t length = 0;
            for (std::size_t i = 0; i < length_bytes; ++i)
                length = length << 8 | lengths[y * length_bytes + i];
            rows_.push_back(at += length);
        }
    }
}

// Into row_.
void PsdPicture::read_row(int channel, int y) {
    const std::size_t i = static_cast<std::size_t>(channel) * static_cast<std::size_t>(height_) + y;
    std::vector<unsigned char>& bytes = packed_ ? packed_row_ : row_;
    const std::uint64_t length = rows_[i + 1] - rows_[i];
    if (length > 2 * row_.size() + 2) fail_at_row(y);  // more than runs of single bytes have
    bytes.resize(length);
    if (::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(rows_[i])) !=
            static_cast<ssize_t>(bytes.size()) ||
        (packed_ && !unpack(packed_row_, row_)))
        fail_at_row(y);
}

void PsdPicture::read(int begin, int end, float* pixels) {
    if (rows_.empty()) {
        find_rows();
        find_white();
    }
    read_values(begin, end, pixels);
    const auto count = static_cast<std::size_t>(channels());
    float* const behind =
        pixels + static_cast<std::size_t>(width_) * static_cast<std::size_t>(end - begin) * count;
    for (; mixed_with_white_ && pixels != behind; pixels += count) {
        const float alpha = pixels[count - 1];
        for (std::size_t k = 0; k + 1 < count; ++k)
            pixels[k] = alpha > 0 ? std::max((pixels[k] - (1 - alpha)) / alpha, 0.0f) : 1.0f;
    }
}

// Photoshop stores colours mixed with white, as they look on it; other programs, such as ImageMagick, store
// them as they are. A colour darker than the white in it would be is not mixed with any.
void PsdPicture::find_white() {
    constexpr float kRounded = 1.5f / 255;
    const auto count = static_cast<std::size_t>(channels());
    std::vector<float> row(static_cast<std::size_t>(width_) * count);
    for (int y = 0; y < height_ && mixed_with_white_; ++y) {
        read_values(y, y + 1, row.data());
        for (std::size_t i = 0; i < row.size(); ++i)
            if (row[i] < 1 - row[i - i % count + count - 1] - kRounded && i % count + 1 < count)
                mixed_with_white_ = false;
    }
}

void PsdPicture::read_values(int begin, int end, float* pixels) {
    const auto width = static_cast<std::size_t>(width_), count = static_cast<std::size_t>(channels());
    for (int y = begin; y < end; ++y, pixels += width * count) {
        for (std::size_t channel = 0; channel < count; ++channel) {
            read_row(static_cast<int>(channel), y);
            const unsigned char* from = row_.data();
            for (std::size_t x = 0; x < width; ++x, from += bits_ / 8) {
                float& value = pixels[x * count + channel];
                if (bits_ == 8)
                    value = static_cast<float>(from[0]) / 255.0f;
                else if (bits_ == 16)
                    value = static_cast<float>(from[0] << 8 | from[1]) / 65535.0f;
                else
                    value = std::bit_cast<float>(std::uint32_t{from[0]} << 24 | std::uint32_t{from[1]} << 16 |
                                                 std::uint32_t{from[2]} << 8 | from[3]);
            }
        }
    }
}

}  // namespace dapple
