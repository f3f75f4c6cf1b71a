#include "app/decoding/image_pipe.h"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

namespace dapple {
namespace {

constexpr std::size_t kBufferBytes = 1 << 18;
constexpr std::size_t kLongestText = 1 << 12;
constexpr char kPicture = 'p', kRow = 'r', kError = 'e', kTooManyPixels = 'm';

struct Numbers {
    std::int32_t width, height, orientation, grey, scene_light;
};

class Reader {
 public:
    explicit Reader(int descriptor) : descriptor_(descriptor), buffer_(kBufferBytes) {}

    // False at the end.
    bool get(void* to, std::size_t size) {
        char* next = static_cast<char*>(to);
        while (size > 0) {
            if (at_ == filled_ && !fill()) return false;
            const std::size_t part = std::min(size, filled_ - at_);
            std::memcpy(next, buffer_.data() + at_, part);
            next += part, at_ += part, size -= part;
        }
        return true;
    }

    std::string text() {
        std::uint32_t size = 0;
        if (!get(&size, sizeof size) || size > kLongestText) return "";
        std::string text(size, '\0');
        return get(text.data(), size) ? text : "";
    }

 private:
    bool fill() {
        ssize_t got = 0;
        do got = ::read(descriptor_, buffer_.data(), buffer_.size());
        while (got < 0 && errno == EINTR);
        at_ = 0;
        filled_ = got > 0 ? static_cast<std::size_t>(got) : 0;
        return got > 0;
    }

    int descriptor_;
    std::vector<char> buffer_;
    std::size_t at_ = 0, filled_ = 0;
};

[[noreturn]] void fail(Reader& reader, char kind) {
    const std::string sentence = reader.text();
    if (kind == kTooManyPixels) throw TooManyPixels(sentence);
    if (kind != kError) throw DecodeError("its decoder says nothing that can be understood");
    if (sentence == kTooMuchMemory) throw DecodeError(sentence);
    throw DamagedFile(sentence);
}

}  // namespace

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
        for (const auto* text :
             {&header_.description, &header_.thumbnail_of.uri, &header_.thumbnail_of.modified})
            put_text(*text);
    }
    put(&kRow, 1);
    if (header_.grey) {
        for (const glm::vec3& colour : colours) put(&colour.x, sizeof(float));
    } else {
        put(colours.data(), colours.size_bytes());
    }
}

void ImagePipe::finish() {
    flush();
}

void ImagePipe::fail(const std::string& sentence, bool too_many_pixels) {
    put(too_many_pixels ? &kTooManyPixels : &kError, 1);
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

bool receive_image(int descriptor, const DecodeRequest& request, ImageSink& sink) {
    Reader reader(descriptor);
    char kind = 0;
    if (!reader.get(&kind, 1)) return false;
    if (kind != kPicture) fail(reader, kind);
    Numbers numbers{};
    if (!reader.get(&numbers, sizeof numbers)) return false;
    // In braces, each is read after the one before.
    const ImageHeader header{.width = numbers.width,
                             .height = numbers.height,
                             .orientation = numbers.orientation,
                             .grey = numbers.grey != 0,
                             .description = reader.text(),
                             .scene_light = numbers.scene_light != 0,
                             .thumbnail_of = {.uri = reader.text(), .modified = reader.text()}};
    check_size(header.width, header.height, 1, request);
    sink.begin(header);
    std::vector<glm::vec3> colours(static_cast<std::size_t>(header.width));
    std::vector<float> greys(header.grey ? colours.size() : 0);
    for (int y = 0; y < header.height; ++y) {
        if (!reader.get(&kind, 1)) return false;
        if (kind != kRow) fail(reader, kind);
        if (header.grey) {
            if (!reader.get(greys.data(), greys.size() * sizeof(float))) return false;
            for (std::size_t i = 0; i < greys.size(); ++i) colours[i] = glm::vec3(greys[i]);
        } else if (!reader.get(colours.data(), colours.size() * sizeof(glm::vec3))) {
            return false;
        }
        sink.row(colours);
    }
    return true;
}

}  // namespace dapple
