#include "io/decoding/image_pipe.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/text/shown_text.h"
#include "io/decoding/decoder_limits.h"

namespace dapple {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr std::size_t kBufferBytes = 1 << 18;
constexpr std::size_t kLongestText = 1 << 12;
constexpr char kSize = 's', kPicture = 'p', kRow = 'r', kDamaged = 'e', kTooManyPixels = 'm', kSystem = 'x';

struct Numbers {
    std::int32_t width, height, orientation, grey, scene_light;
};

// The pipe has no more.
struct Ended {};

[[noreturn]] void fail_nonsense(const std::string& what) {
    throw DecodeError("its decoder sent something impossible: " + what);
}

class Reader {
 public:
    Reader(int descriptor, const DecoderPatience& patience)
        : descriptor_(descriptor),
          at_first_(patience.at_first),
          per_megabyte_(patience.per_megabyte),
          buffer_(kBufferBytes) {}

    void wait_for(std::uint64_t pixel_bytes) {
        constexpr std::uint64_t kMegabyte = 1'000'000,
                                kMost = 1'000'000;  // of megabytes: nanoseconds hold them
        const milliseconds all =
            at_first_ + per_megabyte_ * static_cast<std::int64_t>(std::min(pixel_bytes / kMegabyte, kMost));
        patience_ = std::max(patience_, all);
    }

    void get(void* to, std::size_t size) {
        char* next = static_cast<char*>(to);
        while (size > 0) {
            if (at_ == filled_) fill();
            const std::size_t part = std::min(size, filled_ - at_);
            std::memcpy(next, buffer_.data() + at_, part);
            next += part, at_ += part, size -= part;
        }
    }

    template <class Value>
    Value get() {
        Value value{};
        get(&value, sizeof value);
        return value;
    }

    std::string text() {
        const auto size = get<std::uint32_t>();
        if (size > kLongestText) fail_nonsense("a text of " + grouped(size) + " bytes");
        std::string text(size, '\0');
        get(text.data(), size);
        return text;
    }

    bool at_end() {
        try {
            get<char>();
        } catch (const Ended&) {
            return true;
        }
        return false;
    }

 private:
    void fill() {
        ssize_t got = -1;
        do {
            wait();
            got = ::read(descriptor_, buffer_.data(), buffer_.size());
        } while (got < 0 && errno == EINTR);
        if (got <= 0) throw Ended();
        at_ = 0;
        filled_ = static_cast<std::size_t>(got);
    }

    // Until there is something to read. What passes while this process is stopped itself counts for little.
    void wait() {
        constexpr milliseconds kLookAgain(1000);
        for (;;) {
            if (waited_ >= patience_) throw DecodeError(kTooMuchTime);
            const nanoseconds part = std::min<nanoseconds>(kLookAgain, patience_ - waited_);
            pollfd waiting{.fd = descriptor_, .events = POLLIN, .revents = 0};
            const auto before = std::chrono::steady_clock::now();
            const int ready =
                ::poll(&waiting, 1, static_cast<int>(std::chrono::ceil<milliseconds>(part).count()));
            const nanoseconds passed = std::chrono::steady_clock::now() - before;
            waited_ += ready == 0 ? part : std::min(part, passed);
            if (ready > 0 || (ready < 0 && errno != EINTR)) return;
        }
    }

    int descriptor_;
    milliseconds at_first_, per_megabyte_, patience_ = at_first_;
    nanoseconds waited_{0};
    std::vector<char> buffer_;
    std::size_t at_ = 0, filled_ = 0;
};

[[noreturn]] void fail(Reader& reader, char kind) {
    if (kind != kDamaged && kind != kTooManyPixels && kind != kSystem)
        throw DecodeError("its decoder sent nothing that can be understood");
    const std::string sentence = printable(reader.text());
    if (sentence.empty()) fail_nonsense("an error without a text");
    if (kind == kTooManyPixels) throw TooManyPixels(sentence);
    throw DecodeError(sentence);
}

bool yes_or_no(std::int32_t number, const char* of_what) {
    if (number != 0 && number != 1) fail_nonsense(std::to_string(number) + " for " + of_what);
    return number == 1;
}

ImageHeader get_header(Reader& reader, const DecodeRequest& request) {
    const auto numbers = reader.get<Numbers>();
    check_size(numbers.width, numbers.height, 1, request);
    if (numbers.orientation < 1 || numbers.orientation > 8)
        fail_nonsense("orientation " + std::to_string(numbers.orientation));
    // In braces, each is read after the one before.
    return {.width = numbers.width,
            .height = numbers.height,
            .orientation = numbers.orientation,
            .grey = yes_or_no(numbers.grey, "grey"),
            .description = printable(reader.text()),
            .scene_light = yes_or_no(numbers.scene_light, "light of a scene"),
            .remark = printable(reader.text())};
}

void check_light(std::span<const float> values, int y) {
    bool light = true;  // which what is no number is not either
    for (const float value : values) light &= std::abs(value) <= kMostLightOfAPixel;
    if (!light) fail_nonsense("a row " + std::to_string(y) + " with values that are no light");
}

void get_picture(Reader& reader, const DecodeRequest& request, ImageSink& sink) {
    constexpr int kMostSizes = 4;
    auto kind = reader.get<char>();
    for (int sizes = 0; kind == kSize && sizes < kMostSizes; ++sizes) {
        reader.wait_for(std::min(reader.get<std::uint64_t>(), most_pixel_bytes(request.most_pixels)));
        kind = reader.get<char>();
    }
    if (kind != kPicture) fail(reader, kind);
    const ImageHeader header = get_header(reader, request);
    sink.begin(header);
    std::vector<glm::vec3> colours(static_cast<std::size_t>(header.width));
    std::vector<float> values(colours.size() * (header.grey ? 1 : 3));
    for (int y = 0; y < header.height; ++y) {
        kind = reader.get<char>();
        if (kind != kRow) fail(reader, kind);
        reader.get(values.data(), values.size() * sizeof(float));
        check_light(values, y);
        if (header.grey)
            std::ranges::transform(values, colours.begin(), [](float grey) { return glm::vec3(grey); });
        else
            std::memcpy(colours.data(), values.data(), values.size() * sizeof(float));
        sink.row(colours);
    }
    if (!reader.at_end()) fail_nonsense("something after the last row");
}

}  // namespace

void ImagePipe::expect(std::uint64_t pixel_bytes) {
    put(&kSize, 1);
    put(&pixel_bytes, sizeof pixel_bytes);
    flush();
}

void ImagePipe::begin(const ImageHeader& header) {
    header_ = header;
}

void ImagePipe::row(std::span<const glm::vec3> colours) {
    if (!started_) {
        started_ = true;
        put(&kPicture, 1);
        const Numbers numbers{header_.width, header_.height, header_.orientation, header_.grey ? 1 : 0,
                              header_.scene_light ? 1 : 0};
        put(&numbers, sizeof numbers);
        put_text(header_.description);
        put_text(header_.remark);
    }
    put(&kRow, 1);
    if (header_.grey) {
        for (const glm::vec3& colour : colours) put(&colour.x, sizeof(float));
    } else {
        put(colours.data(), colours.size_bytes());
    }
}

void ImagePipe::fail(const std::string& sentence, PictureFailure by) {
    put(by == PictureFailure::too_many_pixels ? &kTooManyPixels
        : by == PictureFailure::system        ? &kSystem
                                              : &kDamaged,
        1);
    put_text(sentence);
    flush();
}

void ImagePipe::put_text(const std::string& text) {
    const auto size = static_cast<std::uint32_t>(std::min(text.size(), kLongestText));
    put(&size, sizeof size);
    put(text.data(), size);
}

void ImagePipe::put(const void* bytes, std::size_t size) {
    if (buffer_.size() + size > kBufferBytes) flush();
    buffer_.insert(buffer_.end(), static_cast<const char*>(bytes), static_cast<const char*>(bytes) + size);
}

void ImagePipe::flush() {
    for (std::size_t at = 0; at < buffer_.size();) {
        const ssize_t put = ::write(descriptor_, buffer_.data() + at, buffer_.size() - at);
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) throw std::runtime_error("nobody reads the picture");
        at += static_cast<std::size_t>(put);
    }
    buffer_.clear();
}

bool receive_image(int descriptor, const DecodeRequest& request, ImageSink& sink,
                   const DecoderPatience& patience) {
    Reader reader(descriptor, patience);
    try {
        get_picture(reader, request, sink);
    } catch (const Ended&) {
        return false;
    }
    return true;
}

}  // namespace dapple
