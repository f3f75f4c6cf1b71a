#include "io/decoding/kept_input.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "io/decoding/decoded_image.h"
#include "io/decoding/picture_format.h"
#include "io/signals.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr int kLookAgain = 50;  // milliseconds: so soon is seen that it is to stop

std::string system_words(int error) {
    return std::generic_category().message(error);
}

// 0 at the end.
std::size_t read_some(int from, std::vector<char>& buffer, const std::stop_token& stop) {
    for (;;) {
        // A pipe that nobody writes to yet is neither readable nor at its end.
        pollfd waiting{.fd = from, .events = POLLIN, .revents = 0};
        const int ready = ::poll(&waiting, 1, stop.stop_possible() ? kLookAgain : -1);
        if (stop.stop_requested()) throw DecodeError("was not read to its end: it was stopped");
        if (ready == 0) continue;
        const ssize_t got = ::read(from, buffer.data(), buffer.size());
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EINTR && errno != EAGAIN) throw DecodeError("cannot be read: " + system_words(errno));
    }
}

void write_all(int to, const char* bytes, std::size_t size) {
    while (size > 0) {
        const ssize_t written = ::write(to, bytes, size);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw DecodeError("cannot be kept while it is read: " + system_words(errno));
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
}

// Whether a picture of that format, as far as it is there, has come to its end. `chunk`: of a PNG, where its
// next piece begins, which moves on.
bool is_whole(PictureFormat format, int file, std::uint64_t size, std::uint64_t& chunk) {
    constexpr std::uint64_t kHead = 8, kChecksum = 4, kNowhere = std::uint64_t{1} << 62;
    std::array<unsigned char, kHead> head{};
    const auto read = [&](std::uint64_t at) {
        return at + kHead <= size && ::pread(file, head.data(), kHead, static_cast<off_t>(at)) == kHead;
    };
    if (format == PictureFormat::webp)
        return read(0) && size >= kHead + (std::uint64_t{head[7]} << 24 | std::uint64_t{head[6]} << 16 |
                                           std::uint64_t{head[5]} << 8 | head[4]);
    if (format != PictureFormat::png) return false;
    while (read(chunk)) {
        const std::uint64_t next = chunk + kHead + kChecksum +
                                   (std::uint64_t{head[0]} << 24 | std::uint64_t{head[1]} << 16 |
                                    std::uint64_t{head[2]} << 8 | head[3]);
        const std::string_view name(reinterpret_cast<const char*>(head.data()) + 4, 4);
        if (name == "IEND") return size >= next;
        chunk = name.front() == 0 ? kNowhere : next;
    }
    return false;
}

}  // namespace

void keep_input(int from, int to, std::uint64_t most, const std::stop_token& stop) {
    const WriteErrorsInsteadOfSignals said;
    std::vector<char> buffer(std::size_t{1} << 18);
    std::vector<unsigned char> beginning;
    std::optional<PictureFormat> format;
    std::uint64_t kept = 0, chunk = 8;
    while (const std::size_t size = read_some(from, buffer, stop)) {
        if (!format) {
            beginning.insert(beginning.end(), buffer.begin(), buffer.begin() + static_cast<long>(size));
            if (beginning.size() >= kFormatBytes) format = format_or_refusal(beginning);
        }
        if ((kept += size) > most)
            throw DecodeError("is longer than " + std::to_string(most / 1'000'000) +
                              " megabytes, the most that is read from a pipe; save it as a file first");
        write_all(to, buffer.data(), size);
        if (format && is_whole(*format, to, kept, chunk)) return;
    }
}

Descriptor kept_input(int from, const std::stop_token& stop) {
    std::string name = (temporary_folder() / "dapple-XXXXXX").native();
    Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
    if (!file) throw DecodeError("cannot be kept while it is read: " + system_words(errno));
    ::unlink(name.c_str());
    keep_input(from, file.get(), kMostKeptBytes, stop);
    return file;
}

fs::path temporary_folder() {
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    return error ? fs::path("/tmp") : folder;
}

}  // namespace dapple
