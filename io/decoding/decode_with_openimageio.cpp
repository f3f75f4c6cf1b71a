// Any format but PNG. OpenImageIO's headers come with an fmt of their own: nothing else of it here.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>
#include <sys/stat.h>
#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <locale>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/decoding/decoded_image.h"
#include "io/decoding/psd_picture.h"
#include "io/decoding/stored_pixels.h"

struct tiff;

namespace dapple {

namespace {

// The 64-bit floats of a TIFF, which OpenImageIO 2.4 takes for 0 or worse in many files: where rows are asked
// for that are no whole strips, and in all tiles.

class TiffDoubles {
 public:
    /// The page that comes after `page` others in an open file, which stays open. Throws DecodeError, also if
    /// it is not of that size.
    TiffDoubles(int file, int page, int width, int height, int channels)
        // "m": by reading; a file that gets shorter meanwhile would end the process.
        : tiff_(::TIFFFdOpen(::dup(file), "picture", "rm"), &::TIFFClose) {
        if (!tiff_ || ::TIFFSetDirectory(tiff_.get(), static_cast<tdir_t>(page)) == 0)
            throw DecodeError("not a picture that can be read");
        const auto number = [this](std::uint32_t tag) {
            std::uint32_t value = 0;
            ::TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
            return static_cast<int>(std::min<std::uint32_t>(value, INT32_MAX));
        };
        const auto short_number = [this](std::uint32_t tag) {
            std::uint16_t value = 0;
            ::TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
            return static_cast<int>(value);
        };
        width_ = number(TIFFTAG_IMAGEWIDTH);
        height_ = number(TIFFTAG_IMAGELENGTH);
        channels_ = short_number(TIFFTAG_SAMPLESPERPIXEL);
        in_planes_ = short_number(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
        tiled_ = ::TIFFIsTiled(tiff_.get()) != 0;
        piece_width_ = tiled_ ? number(TIFFTAG_TILEWIDTH) : width_;
        piece_height_ = tiled_ ? number(TIFFTAG_TILELENGTH) : std::min(number(TIFFTAG_ROWSPERSTRIP), height_);
        if (short_number(TIFFTAG_BITSPERSAMPLE) != 64 || width_ != width || height_ != height ||
            channels_ != channels || piece_width_ <= 0 || piece_height_ <= 0)
            throw DecodeError("not a picture that can be read");
        const tmsize_t bytes = tiled_ ? ::TIFFTileSize(tiff_.get()) : ::TIFFStripSize(tiff_.get());
        piece_.resize(static_cast<std::size_t>(bytes) / sizeof(double));
    }

    /// Rows [begin, end) as floats, all channels of a pixel beside each other. `begin` is the first row of a
    /// strip or of a row of tiles. Throws DecodeError if the file does not have them.
    void read(int begin, int end, float* pixels) {
        const int planes = in_planes_ ? channels_ : 1, per_plane = channels_ / planes;
        const auto read_piece = [&](int x, int y, int plane, int rows) {
            const auto ux = static_cast<std::uint32_t>(x), uy = static_cast<std::uint32_t>(y);
            const auto sample = static_cast<std::uint16_t>(plane);
            const auto bytes = static_cast<tmsize_t>(piece_.size() * sizeof(double));
            const tmsize_t got =
                tiled_ ? ::TIFFReadEncodedTile(tiff_.get(), ::TIFFComputeTile(tiff_.get(), ux, uy, 0, sample),
                                               piece_.data(), bytes)
                       : ::TIFFReadEncodedStrip(tiff_.get(), ::TIFFComputeStrip(tiff_.get(), uy, sample),
                                                piece_.data(), bytes);
            const std::size_t needed = static_cast<std::size_t>(piece_width_) * per_plane *
                                       static_cast<std::size_t>(tiled_ ? piece_height_ : rows) *
                                       sizeof(double);
            if (got < 0 || static_cast<std::size_t>(got) < needed || piece_.size() * sizeof(double) < needed)
                throw DecodeError("the picture is damaged (row " + std::to_string(y) + " is not there)");
        };
        for (int y = begin; y < end; y += piece_height_) {
            const int rows = std::min(piece_height_, height_ - y), kept_rows = std::min(rows, end - y);
            for (int x = 0; x < width_; x += piece_width_) {
                const int columns = std::min(piece_width_, width_ - x);
                for (int plane = 0; plane < planes; ++plane) {
                    read_piece(x, y, plane, rows);
                    for (int row = 0; row < kept_rows; ++row) {
                        const double* from =
                            piece_.data() + static_cast<std::size_t>(row) * piece_width_ * per_plane;
                        float* to = pixels +
                                    (static_cast<std::size_t>(y - begin + row) * width_ + x) * channels_ +
                                    plane;
                        for (int column = 0; column < columns; ++column, to += channels_)
                            for (int k = 0; k < per_plane; ++k) to[k] = static_cast<float>(*from++);
                    }
                }
            }
        }
    }

 private:
    std::unique_ptr<tiff, void (*)(tiff*)> tiff_;
    int width_ = 0, height_ = 0, channels_ = 1;
    bool tiled_ = false, in_planes_ = false;  // in planes, each channel is by itself
    int piece_width_ = 0, piece_height_ = 0;  // of a strip or tile
    std::vector<double> piece_;
};

// What a Radiance picture says of itself (radsite.lbl.gov/radiance/refer/filefmts.pdf), read without a
// library.

struct RadianceHeader {
    /// The header of the same pixels, first row first, as OpenImageIO reads it: that needs a FORMAT, and
    /// numbers two of the eight orders of rows and columns by each other's EXIF number.
    std::string plain;
    std::size_t size = 0;    // bytes before the pixels
    int orientation = 1;     // EXIF's, of the stored rows
    float pixel_aspect = 1;  // a stored pixel's length along its row for that across
    /// From the values to the light: they were multiplied by every EXPOSURE and every COLORCORR.
    glm::mat3 light = glm::mat3(1);
};

// The numbers of a line after its "="; those that are not there are 0.
glm::dvec3 numbers_in(std::string_view line) {
    std::istringstream numbers(std::string(line.substr(line.find('=') + 1)));
    numbers.imbue(std::locale::classic());
    glm::dvec3 read(0);
    numbers >> read.x >> read.y >> read.z;
    return read;
}

// "-Y 480 +X 640": rows from the top down, each from left to right. The axis that comes first is that across
// the stored rows.
struct Order {
    std::string_view first, second;
    int orientation;
    bool of_columns() const { return first[1] == 'X'; }
};
constexpr std::array<Order, 8> kOrders{{{"-Y", "+X", 1},
                                        {"-Y", "-X", 2},
                                        {"+Y", "-X", 3},
                                        {"+Y", "+X", 4},
                                        {"+X", "-Y", 5},
                                        {"-X", "-Y", 6},
                                        {"-X", "+Y", 7},
                                        {"+X", "+Y", 8}}};

// Of an open file, whose descriptor keeps its place. Throws DecodeError with a sentence if it is none that
// can be read: its pixels are XYZ, it has no size, an EXPOSURE or COLORCORR that is not a number over 0.
RadianceHeader radiance_header(int file) {
    std::array<char, 1 << 16> beginning{};
    const ssize_t got = ::pread(file, beginning.data(), beginning.size(), 0);
    std::string_view rest(beginning.data(), got < 0 ? 0 : static_cast<std::size_t>(got));
    const auto take_line = [&rest]() -> std::optional<std::string_view> {
        const std::size_t end = rest.find('\n');
        if (end == rest.npos) return std::nullopt;
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    };
    RadianceHeader header{.plain = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"};
    glm::dvec3 multiplied(1);
    double height_for_width = 1;
    for (;;) {
        const auto line = take_line();
        if (!line) throw DecodeError("the picture is damaged (its header has no end)");
        if (line->empty()) break;
        if (line->starts_with("FORMAT=32-bit_rle_xyze"))
            throw DecodeError(
                "has colours as XYZ, which cannot be read here; Radiance's ra_xyze -r makes them red, green "
                "and blue");
        if (line->starts_with("FORMAT=") && line->find("32-bit_rle_rgbe") == line->npos)
            throw DecodeError("has pixels of a format that is not Radiance's: " +
                              std::string(line->substr(7)));
        if (line->starts_with("EXPOSURE=")) multiplied *= numbers_in(*line).x;
        if (line->starts_with("COLORCORR=")) multiplied *= numbers_in(*line);
        if (line->starts_with("PIXASPECT=")) height_for_width *= numbers_in(*line).x;
        if (line->starts_with("GAMMA=")) header.plain += std::string(*line) + '\n';
    }
    const glm::dvec3 light = 1.0 / multiplied;
    for (int i = 0; i < 3; ++i) {
        if (!(light[i] > 0 && light[i] <= kMostLightOfAPixel))
            throw DecodeError(
                "says in its header by which EXPOSURE or COLORCORR its light was multiplied, and that is not "
                "a number over 0; mend these lines or leave them out");
        header.light[i][i] = static_cast<float>(light[i]);
    }
    std::istringstream size(std::string(take_line().value_or("")));
    std::string first, second;
    long rows = 0, columns = 0;
    size >> first >> rows >> second >> columns;
    const auto order = std::ranges::find_if(
        kOrders, [&](const Order& known) { return known.first == first && known.second == second; });
    if (order == kOrders.end() || rows <= 0 || columns <= 0)
        throw DecodeError("the picture is damaged (its header has no size such as -Y 480 +X 640)");
    header.orientation = order->orientation;
    // Where a row is upright in the picture, its pixels lie on their sides.
    header.pixel_aspect = static_cast<float>(order->of_columns() ? height_for_width : 1 / height_for_width);
    header.plain += "\n-Y " + std::to_string(rows) + " +X " + std::to_string(columns) + '\n';
    header.size = static_cast<std::size_t>(got) - rest.size();
    return header;
}

// A file that begins otherwise: what OpenImageIO reads in place of one that it reads wrong.

class ChangedBeginning : public OIIO::Filesystem::IOProxy {
 public:
    /// `beginning`, and after it what the open file has from `rest` on.
    ChangedBeginning(std::vector<unsigned char> beginning, int file, std::uint64_t rest)
        : IOProxy("picture", Read), beginning_(std::move(beginning)), file_(file), rest_(rest) {}

    const char* proxytype() const override { return "changed beginning"; }
    std::size_t read(void* to, std::size_t size) override {
        const std::size_t got = pread(to, size, m_pos);
        m_pos += static_cast<std::int64_t>(got);
        return got;
    }
    std::size_t pread(void* to, std::size_t size, std::int64_t at) override {
        if (at < 0) return 0;
        auto place = static_cast<std::uint64_t>(at);
        auto* const bytes = static_cast<unsigned char*>(to);
        std::size_t got = 0;
        if (place < beginning_.size()) {
            got = std::min<std::size_t>(size, beginning_.size() - place);
            std::copy_n(beginning_.begin() + at, got, bytes);
            place += got;
        }
        while (got < size) {
            const std::uint64_t in_file = place - beginning_.size() + rest_;
            if (in_file > INT64_MAX) break;
            const ssize_t more = ::pread(file_, bytes + got, size - got, static_cast<off_t>(in_file));
            if (more <= 0) break;
            got += static_cast<std::size_t>(more);
            place += static_cast<std::uint64_t>(more);
        }
        return got;
    }
    std::size_t size() const override {
        struct stat status {};
        if (::fstat(file_, &status) != 0) return beginning_.size();
        const auto all = static_cast<std::uint64_t>(status.st_size);
        return beginning_.size() + (all > rest_ ? all - rest_ : 0);
    }

 private:
    std::vector<unsigned char> beginning_;
    int file_;
    std::uint64_t rest_;
};

// BMP files whose pixels are kept as runs (RLE). OpenImageIO 2.4 reads those of greys wrong, and refuses ends
// of lines after the last row, which many programs write.

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

// The same picture as a BMP file of 8 bits a pixel without runs. Nothing: it has none. Throws DecodeError if
// it ends before its last row does, or goes on after it.
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

constexpr int kBandRows = 64;
constexpr const char* kWholeOnly = "is read as a whole only";

// `what`, and in brackets what a codec says, without its line ends and without the descriptor that it took
// for the file's name.
DecodeError error_of(const std::string& what, std::string message, const std::string& name) {
    // Some codecs catch it and say its name.
    if (message.find("bad_alloc") != message.npos) return DecodeError(kTooMuchMemory);
    for (const std::string& part :
         {" (\"" + name + "\")", " \"" + name + "\"", "\"" + name + "\"", " " + name, name})
        for (std::size_t at; (at = message.find(part)) != message.npos;) message.erase(at, part.size());
    if (const std::size_t end = message.find('\n'); end != message.npos) message.resize(end);
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
    message.erase(0, message.find_first_not_of(' '));
    return DecodeError(message.empty() ? what : what + " (" + message + ")");
}

// Some readers take memory for a whole picture to look at its header: its size is judged before.
void expect_stated_size(int file, PictureFormat format, const DecodeRequest& request,
                        const BeforePixels& before_pixels) {
    constexpr int kChannels = 4;
    std::array<unsigned char, kFormatBytes> beginning{};
    const ssize_t got = ::pread(file, beginning.data(), beginning.size(), 0);
    if (got < 0) return;
    const auto size = stated_size(format, {beginning.data(), static_cast<std::size_t>(got)});
    if (!size) return;
    check_size(size->width, size->height, kChannels, request);
    const auto row = static_cast<std::uint64_t>(size->width * kChannels),
               bytes = row * static_cast<std::uint64_t>(size->height);
    before_pixels({.in_memory = bytes + row * kBandRows * sizeof(float), .in_all = bytes});
}

// `halved`: a raw file's picture in half its size, for which no colours are guessed between the sensor's.
// `from`: what it is read from instead of the file of that name, if there is any.
std::unique_ptr<OIIO::ImageInput> open_picture(const std::string& name, PictureFormat format, bool halved,
                                               OIIO::Filesystem::IOProxy* from) {
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(std::string(reader_of(format)));
    if (!input) throw DecodeError("cannot be read: " + OIIO::geterror());
    if (from) input->set_ioproxy(from);
    OIIO::ImageSpec spec, wishes;
    // Colours as stored: dividing 8-bit colours by alpha again would lose them.
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    if (halved) wishes.attribute("raw:half_size", 1);
    if (!input->open(name, spec, wishes))
        throw error_of("not a picture that can be read", input->geterror(), name);
    // Some files begin with a header that has no picture.
    int picture = 0;
    while (input->spec().width <= 0 || input->spec().height <= 0)
        if (!input->seek_subimage(++picture, 0)) throw DecodeError("there is no picture in the file");
    return input;
}

Channels channels_of(const OIIO::ImageSpec& spec, PictureFormat format) {
    Channels channels;
    const auto named = [&](std::string_view name) {
        const auto same = [&](const std::string& other) {
            return OIIO::Strutil::iequals(other, std::string(name));
        };
        const auto found = std::ranges::find_if(spec.channelnames, same);
        return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
    };
    // Where OpenImageIO says that it is none of the channels, as of GIF, it has its name. Grey TGA has none
    // either.
    const int alpha = spec.alpha_channel >= 0 && spec.alpha_channel < spec.nchannels ? spec.alpha_channel
                      : format == PictureFormat::targa && spec.nchannels == 2        ? 1
                                                                                     : named("A");
    if (alpha >= 0) channels.alpha = alpha;
    const int red = named("R"), green = named("G"), blue = named("B"), luminance = named("Y");
    if (red >= 0 && green >= 0 && blue >= 0) {
        channels.colour = {red, green, blue};
    } else if (luminance >= 0) {
        channels.colour = {luminance, luminance, luminance};
    } else {
        std::vector<int> others;
        for (int i = 0; i < spec.nchannels; ++i)
            if (i != channels.alpha) others.push_back(i);
        if (others.empty()) others.push_back(0);
        if (others.size() >= 3)
            channels.colour = {others[0], others[1], others[2]};
        else
            channels.colour.fill(others[0]);
    }
    if (channels.alpha && *channels.alpha == channels.colour[0]) channels.alpha.reset();
    return channels;
}

Encoding encoding_of(const OIIO::ImageSpec& spec) {
    const std::string name = OIIO::Strutil::lower(spec.get_string_attribute("oiio:ColorSpace"));
    if (name.starts_with("lin") || name == "scene_linear") return {Encoding::Kind::linear};
    const bool srgb = name.starts_with("srgb");
    // "Gamma2.2", or some name for it, with the number beside it; release 3 says "g22_rec709_scene".
    float gamma = srgb ? 0 : spec.get_float_attribute("oiio:Gamma", 0.0f);
    if (gamma <= 0 && name.starts_with("gamma")) gamma = OIIO::Strutil::from_string<float>(name.substr(5));
    if (gamma == 1) return {Encoding::Kind::linear};
    if (gamma > 0) return {Encoding::Kind::power, gamma};
    // PFM's floats are light, though OpenImageIO takes them for encoded as PPM's integers are.
    if (spec.format.is_floating_point() && !srgb) return {Encoding::Kind::linear};
    return {Encoding::Kind::srgb};
}

// The ICC profile of integer pixels; floats are light, whatever profile they are shown by.
std::string profile_of(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const icc = spec.find_attribute("ICCProfile");
    if (!icc || icc->type().basetype != OIIO::TypeDesc::UINT8 || spec.format.is_floating_point()) return {};
    return {static_cast<const char*>(icc->data()), static_cast<std::size_t>(icc->datasize())};
}

// Whether colours come multiplied by alpha. Readers that leave them alone do not all say so.
bool is_premultiplied(const OIIO::ImageSpec& spec, PictureFormat format) {
    constexpr int kPremultipliedTarga = 4;
    if (spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0) return false;
    if (format == PictureFormat::targa)
        return spec.get_int_attribute("targa:alpha_type", 0) == kPremultipliedTarga;
    return format != PictureFormat::bmp && format != PictureFormat::gif && format != PictureFormat::jpeg2000;
}

PixelLayout layout_of(const OIIO::ImageSpec& spec, PictureFormat format) {
    PixelLayout layout;
    layout.channels = channels_of(spec, format);
    layout.count = spec.nchannels;
    layout.encoding = encoding_of(spec);
    layout.profile = profile_of(spec);
    layout.premultiplied = layout.channels.alpha && is_premultiplied(spec, format);
    layout.eight_bit = spec.format == OIIO::TypeDesc::UINT8;
    return layout;
}

std::string kind_of(const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point()) return "float";
    const int bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(spec.format.size()) * 8);
    return std::to_string(bits) + "-bit";
}

// Goes to the smallest of the picture's copies in the file whose longer side is long enough: mipmaps, and in
// TIFF pages that are said to be such. Throws DecodeError if there is none of half its size or less.
void go_to_smaller(OIIO::ImageInput& input, int enough_side) {
    constexpr int kMostCopies = 31;  // each is half as large
    const OIIO::ImageSpec whole = input.spec();
    const auto longer_side = [](const OIIO::ImageSpec& spec) { return std::max(spec.width, spec.height); };
    const int picture = input.current_subimage();
    int smallest = longer_side(whole) / 2 + 1, found_in = -1, found_level = 0;
    const auto look = [&](int subimage, int level) {
        const OIIO::ImageSpec& copy = input.spec();
        const int side = longer_side(copy);
        const std::int64_t skew =
            std::int64_t{copy.width} * whole.height - std::int64_t{copy.height} * whole.width;
        if (side < enough_side || side >= smallest || std::abs(skew) > longer_side(whole)) return;
        smallest = side;
        found_in = subimage;
        found_level = level;
    };
    for (int level = 1; level <= kMostCopies && input.seek_subimage(picture, level); ++level)
        look(picture, level);
    const auto is_copy = [&] { return (input.spec().get_int_attribute("tiff:subfiletype") & 1) != 0; };
    for (int page = picture + 1; page <= picture + kMostCopies && input.seek_subimage(page, 0) && is_copy();
         ++page)
        look(page, 0);
    static_cast<void>(input.geterror());  // of the copy after the last
    if (found_in < 0 || !input.seek_subimage(found_in, found_level)) throw DecodeError(kWholeOnly);
}

// How many rows are read at a time: whole tiles or strips where their library has to be asked for them.
int band_rows_of(const OIIO::ImageSpec& spec, bool whole_strips) {
    int rows = kBandRows;
    if (spec.tile_width != 0) {
        rows = spec.tile_height;
    } else if (whole_strips) {
        const int strip = std::clamp(spec.get_int_attribute("tiff:RowsPerStrip", 1), 1, spec.height);
        rows = strip * std::max(1, kBandRows / strip);
    }
    return std::min(rows, spec.height);
}

// Rows [begin, end) of the file as floats.
bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int begin, int end, float* pixels) {
    const int subimage = input.current_subimage(), level = input.current_miplevel();
    if (spec.tile_width == 0)
        return input.read_scanlines(subimage, level, spec.y + begin, spec.y + end, spec.z, 0, spec.nchannels,
                                    OIIO::TypeDesc::FLOAT, pixels);
    return input.read_tiles(subimage, level, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end,
                            spec.z, spec.z + 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels);
}

// In formats of Windows' the fourth byte of a pixel is often of no use, and then 0 everywhere: a picture that
// is transparent all over nobody would keep.
void forget_unused_alpha(PixelLayout& layout, const OIIO::ImageSpec& spec, int band_rows,
                         std::span<const float> band, const std::function<void(int, int)>& read) {
    if (!layout.channels.alpha) return;
    const auto alpha = static_cast<std::size_t>(*layout.channels.alpha),
               count = static_cast<std::size_t>(spec.nchannels);
    for (int begin = 0; begin < spec.height; begin += band_rows) {
        const int end = std::min(begin + band_rows, spec.height);
        read(begin, end);
        const std::size_t values = count * static_cast<std::size_t>(spec.width) * (end - begin);
        for (std::size_t i = alpha; i < values; i += count)
            if (band[i] > 0) return;
    }
    layout.channels.alpha.reset();
    layout.premultiplied = false;
}

// How wide a pixel is for its height, by the resolutions across and down. Those of JFIF are read here:
// OpenImageIO leaves some of them out, and has others the wrong way round.
float pixel_aspect_of(const OIIO::ImageSpec& spec, int file, PictureFormat format) {
    std::array<unsigned char, 18> jfif{};
    if (format == PictureFormat::jpeg && ::pread(file, jfif.data(), jfif.size(), 0) == 18 &&
        std::string_view(reinterpret_cast<const char*>(jfif.data()) + 6, 4) == "JFIF") {
        const int across = jfif[14] << 8 | jfif[15], down = jfif[16] << 8 | jfif[17];
        return across > 0 && down > 0 ? static_cast<float>(down) / static_cast<float>(across) : 1;
    }
    const float across = spec.get_float_attribute("XResolution", 0),
                down = spec.get_float_attribute("YResolution", 0);
    if (across > 0 && down > 0) return down / across;
    return format == PictureFormat::jpeg ? 1 : spec.get_float_attribute("PixelAspectRatio", 1);
}

// The picture's window, where that is not just what is stored. Only these two formats have one: what
// OpenImageIO says of TGA and JPEG 2000 are places on a screen or a grid.
std::optional<DisplayWindow> window_of(const OIIO::ImageSpec& spec, PictureFormat format) {
    if ((format != PictureFormat::openexr && format != PictureFormat::tiff) ||
        OIIO::Strutil::starts_with(spec.get_string_attribute("textureformat"), "CubeFace"))
        return std::nullopt;
    const DisplayWindow window{.width = spec.full_width,
                               .height = spec.full_height,
                               .x = std::int64_t{spec.x} - spec.full_x,
                               .y = std::int64_t{spec.y} - spec.full_y};
    if (window.x == 0 && window.y == 0 && window.width == spec.width && window.height == spec.height)
        return std::nullopt;
    return window;
}

}  // namespace

void decode(int file, PictureFormat format, const DecodeRequest& request, const BeforePixels& before_pixels,
            ImageSink& sink) {
    expect_stated_size(file, format, request, before_pixels);
    std::unique_ptr<ChangedBeginning> from;
    std::optional<RadianceHeader> radiance;
    std::optional<PsdPicture> psd;
    if (format == PictureFormat::radiance) {
        radiance = radiance_header(file);
        from.reset(
            new ChangedBeginning({radiance->plain.begin(), radiance->plain.end()}, file, radiance->size));
    } else if (format == PictureFormat::psd) {
        psd.emplace(file);
        from = std::make_unique<ChangedBeginning>(psd->beginning(), file, psd->rest());
    } else if (format == PictureFormat::bmp) {
        if (auto plain = bmp_without_runs(file))
            from = std::make_unique<ChangedBeginning>(std::move(*plain), file, INT64_MAX);
    }
    const std::string name = "/dev/fd/" + std::to_string(file);
    const bool halved = format == PictureFormat::raw && request.enough_side > 0;
    const std::unique_ptr<OIIO::ImageInput> input = open_picture(name, format, halved, from.get());
    OIIO::ImageSpec whole = input->spec();
    const std::optional<DisplayWindow> window = window_of(whole, format);
    if (window) check_size(window->width, window->height, whole.nchannels, request);
    if (window && request.enough_side > 0) throw DecodeError(kWholeOnly);
    if (halved) {
        if (std::max(whole.width, whole.height) < request.enough_side) throw DecodeError(kWholeOnly);
        whole.width *= 2;
        whole.height *= 2;
    }
    check_size(whole.width, whole.height, whole.nchannels, request);
    if (request.enough_side > 0 && !halved) go_to_smaller(*input, request.enough_side);
    OIIO::ImageSpec spec = input->spec();
    if (psd && psd->has_transparency()) {
        spec.nchannels = psd->channels();
        spec.alpha_channel = spec.nchannels - 1;
        spec.channelnames.resize(static_cast<std::size_t>(spec.nchannels), "A");
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    check_size(spec.width, spec.height, spec.nchannels, request);
    if (spec.get_string_attribute("oiio:ColorSpace") == "color separated")
        throw DecodeError(
            "is in inks for print, such as CMYK, which cannot be read here; save it as RGB or grey");

    const std::size_t row_values = static_cast<std::size_t>(spec.width) * spec.nchannels;
    const bool in_doubles = format == PictureFormat::tiff && spec.format == OIIO::TypeDesc::DOUBLE;
    const int band_rows = band_rows_of(spec, in_doubles);
    const std::size_t stored = row_values * spec.height * std::max<std::size_t>(spec.format.size(), 1);
    before_pixels({.in_memory = stored + row_values * band_rows * sizeof(float), .in_all = stored});
    std::vector<float> band(row_values * band_rows);
    std::optional<TiffDoubles> doubles;
    // A page is one that OpenImageIO takes for a picture of the file's or for a copy of the first.
    const int page = input->current_subimage() + input->current_miplevel();
    if (in_doubles) doubles.emplace(file, page, spec.width, spec.height, spec.nchannels);
    const auto read = [&](int begin, int end) {
        if (doubles) return doubles->read(begin, end, band.data());
        if (psd && psd->has_transparency()) return psd->read(begin, end, band.data());
        // The JPEG reader goes on after a file ends too early, but says so.
        if (!read_rows(*input, spec, begin, end, band.data()) || input->has_error())
            throw error_of("the picture is damaged", input->geterror(), name);
    };

    PixelLayout layout = layout_of(spec, format);
    if (radiance) layout.to_srgb = radiance->light;
    if (format == PictureFormat::bmp || format == PictureFormat::targa)
        forget_unused_alpha(layout, spec, band_rows, band, read);
    const int orientation = radiance ? radiance->orientation : whole.get_int_attribute("Orientation", 1);
    const int width = window ? window->width : whole.width, height = window ? window->height : whole.height;
    const ImageHeader header{
        .width = spec.width,
        .height = spec.height,
        .orientation = orientation >= 1 && orientation <= 8 ? orientation : 1,
        .grey = layout.channels.grey(),
        .description = describe(width, height, kind_of(whole), layout.channels, input->format_name()),
        .scene_light = spec.format.is_floating_point() && layout.encoding.kind == Encoding::Kind::linear,
        .pixel_aspect = radiance ? radiance->pixel_aspect : pixel_aspect_of(whole, file, format),
        .window = window};
    layout.over_paper = request.over_paper;
    StoredPixels decoder(layout);
    std::vector<glm::vec3> colours(spec.width);
    for (int begin = 0; begin < spec.height; begin += band_rows) {
        const int end = std::min(begin + band_rows, spec.height);
        read(begin, end);
        if (begin == 0) sink.begin(header);
        for (int y = begin; y < end; ++y) {
            decoder.decode({band.data() + (y - begin) * row_values, row_values}, y, colours);
            sink.row(colours);
        }
    }
}

}  // namespace dapple
