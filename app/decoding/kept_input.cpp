#include "app/decoding/kept_input.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "app/decoding/decoded_image.h"
#include "app/decoding/picture_format.h"
#include "app/signals.h"

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

}  // namespace

void keep_input(int from, int to, std::uint64_t most, const std::stop_token& stop) {
    const WriteErrorsInsteadOfSignals said;
    std::vector<char> buffer(std::size_t{1} << 18);
    std::vector<unsigned char> beginning;
    bool known = false;
    std::uint64_t kept = 0;
    while (const std::size_t size = read_some(from, buffer, stop)) {
        if (!known) {
            beginning.insert(beginning.end(), buffer.begin(), buffer.begin() + static_cast<long>(size));
            known = beginning.size() >= kFormatBytes;
            if (known) format_or_refusal(beginning);
        }
        if ((kept += size) > most)
            throw DecodeError("is longer than " + std::to_string(most / 1'000'000) +
                              " megabytes, the most that is read from a pipe; save it as a file first");
        write_all(to, buffer.data(), size);
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
