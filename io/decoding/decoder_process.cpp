#include "io/decoding/decoder_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/decoding/decoder_sandbox.h"
#include "io/signals.h"

extern char** environ;

namespace dapple {

namespace {

namespace fs = std::filesystem;

constexpr int kLookAgain = 50;  // milliseconds: so soon is seen that it is to stop

std::string reason(int error) {
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
        if (errno != EINTR && errno != EAGAIN) throw DecodeError("cannot be read: " + reason(errno));
    }
}

void write_all(int to, const char* bytes, std::size_t size) {
    while (size > 0) {
        const ssize_t written = ::write(to, bytes, size);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw DecodeError("cannot be kept while it is read: " + reason(errno));
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
}

// Whether a picture of that format, as far as it is there, has come to its end. `chunk`: of a PNG, where its
// next piece begins, which moves on.
bool is_whole(PictureFormat format, int file, std::uint64_t size, std::uint64_t& chunk) {
    constexpr std::uint64_t kHead = 8, kChecksum = 4, kEnd = 0x49454e44;  // "IEND"
    constexpr std::uint64_t kNowhere = std::uint64_t{1} << 62;
    if (format == PictureFormat::webp) return size >= kHead + number_in_file(file, 4, 4, false);
    if (format != PictureFormat::png) return false;
    while (chunk + kHead <= size) {
        const std::uint64_t next = chunk + kHead + kChecksum + number_in_file(file, chunk, 4);
        const std::uint64_t name = number_in_file(file, chunk + 4, 4);
        if (name == kEnd) return size >= next;
        chunk = name >> 24 == 0 ? kNowhere : next;
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

fs::path temporary_folder() {
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    return error ? fs::path("/tmp") : folder;
}

namespace {

// What the first page of a TIFF file says of itself, read without a library.

class TiffPage {
 public:
    /// The page of an open file, whose descriptor keeps its place. For a file that is no TIFF, or is broken,
    /// it says something, but harms nobody.
    explicit TiffPage(int file) : file_(file) {
        constexpr std::uint64_t kBigTiff = 43;
        big_endian_ = number_at(0, 1) == 'M';
        const bool big = number_at(2, 2) == kBigTiff;
        if (big) {
            place_bytes_ = 8;
            entry_bytes_ = 20;
        }
        const int count_bytes = big ? 8 : 2;
        const std::uint64_t page = number_at(big ? 8 : 4, place_bytes_);
        entries_ = number_at(page, count_bytes) & 0xffff;
        first_ = page + static_cast<std::uint64_t>(count_bytes);
    }

    /// The first of the numbers, or the place of them, that an entry has. Nothing: there is no such entry.
    std::optional<std::uint64_t> entry(std::uint64_t tag) const {
        constexpr std::uint64_t kByte = 1, kShort = 3;
        for (std::uint64_t i = 0; i < entries_; ++i) {
            const std::uint64_t at = first_ + i * static_cast<std::uint64_t>(entry_bytes_);
            if (number_at(at, 2) != tag) continue;
            const std::uint64_t type = number_at(at + 2, 2);
            const int bytes = type == kByte ? 1 : type == kShort ? 2 : 4;
            return number_at(at + 4 + static_cast<std::uint64_t>(place_bytes_), bytes);
        }
        return std::nullopt;
    }

    /// Whether the page after it is there.
    bool is_followed() const {
        return number_at(first_ + entries_ * static_cast<std::uint64_t>(entry_bytes_), place_bytes_) != 0;
    }

 private:
    std::uint64_t number_at(std::uint64_t at, int bytes) const {
        return number_in_file(file_, at, bytes, big_endian_);
    }

    int file_;
    bool big_endian_ = false;
    // In files over 4 gigabytes, all of these are longer.
    int place_bytes_ = 4, entry_bytes_ = 12;
    std::uint64_t first_ = 0, entries_ = 0;
};

// Whether a TIFF is a camera's raw file: the page with the sensor's values is the first one, or lies behind
// a small picture of it.
bool is_camera_raw(const TiffPage& page) {
    constexpr std::uint64_t kSubfileType = 254, kPhotometric = 262, kPagesWithin = 330, kDngVersion = 50706;
    constexpr std::uint64_t kReduced = 1, kColourFilters = 32803, kLinearRaw = 34892;
    const std::uint64_t photometric = page.entry(kPhotometric).value_or(0);
    return page.entry(kDngVersion) || photometric == kColourFilters || photometric == kLinearRaw ||
           ((page.entry(kSubfileType).value_or(0) & kReduced) != 0 && page.entry(kPagesWithin));
}

// What comes in a new file without a name, which is gone with its descriptor.
Descriptor kept_input(int from, const std::stop_token& stop) {
    std::string name = (temporary_folder() / "dapple-XXXXXX").native();
    Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
    if (!file) throw DecodeError("cannot be kept while it is read: " + reason(errno));
    ::unlink(name.c_str());
    keep_input(from, file.get(), kMostKeptBytes, stop);
    return file;
}

void wait_at_reading(const Descriptor& file) {
    ::fcntl(file.get(), F_SETFL, ::fcntl(file.get(), F_GETFL) & ~O_NONBLOCK);
}

Descriptor open_file(const fs::path& path, const std::stop_token& stop = {}) {
    // A pipe that nobody writes to yet is opened at once: waiting for that could not be stopped.
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!file) throw DecodeError(errno == ENOENT ? "no such file" : "cannot be read: " + reason(errno));
    struct stat status {};
    ::fstat(file.get(), &status);
    if (S_ISDIR(status.st_mode)) throw DecodeError("is a folder, not a picture");
    if (S_ISREG(status.st_mode))
        wait_at_reading(file);
    else
        file = kept_input(file.get(), stop);
    ::fstat(file.get(), &status);
    if (status.st_size == 0) throw DecodeError("the file is empty");
    return file;
}

PictureFormat format_in(const Descriptor& file) {
    std::array<unsigned char, kFormatBytes> beginning;
    const ssize_t got = ::pread(file.get(), beginning.data(), beginning.size(), 0);
    if (got < 0) throw DecodeError("cannot be read: " + reason(errno));
    PictureFormat format = format_or_refusal({beginning.data(), static_cast<std::size_t>(got)});
    if (format == PictureFormat::tiff && is_camera_raw(TiffPage(file.get()))) format = PictureFormat::raw;
    ::lseek(file.get(), 0, SEEK_SET);
    return format;
}

// Whether it is worth the time to start the decoder for a smaller copy of the picture: any JPEG can be read
// smaller, a raw file at half its size, and a TIFF of more than one page or an EXR in tiles or parts may have
// such copies.
bool may_hold_smaller(const Descriptor& file, PictureFormat format) {
    if (format == PictureFormat::jpeg || format == PictureFormat::raw) return true;
    if (format == PictureFormat::openexr) {
        constexpr unsigned char kTilesOrParts = 0x12;  // of the second byte of the flags
        unsigned char flags = 0;
        return ::pread(file.get(), &flags, 1, 5) == 1 && (flags & kTilesOrParts) != 0;
    }
    return format == PictureFormat::tiff && TiffPage(file.get()).is_followed();
}

// Above the numbers that the decoder knows files by: a descriptor given as itself would be closed.
Descriptor above(const Descriptor& file) {
    Descriptor copy(::fcntl(file.get(), F_DUPFD_CLOEXEC, kPictureFile + 1));
    // EINVAL: no such number is allowed.
    if (!copy) throw DecodeError("cannot be read: " + reason(errno == EINVAL ? EMFILE : errno));
    return copy;
}

class Actions {
 public:
    Actions() { posix_spawn_file_actions_init(&actions_); }
    Actions& operator=(Actions&&) = delete;
    ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
    void open(int as, const char* path, int flags) {
        posix_spawn_file_actions_addopen(&actions_, as, path, flags, 0);
    }
    void give(const Descriptor& from, int as) { posix_spawn_file_actions_adddup2(&actions_, from.get(), as); }
    // What somebody left open for others, who may have begun this program with it, is not for a decoder.
    void close_from(int first) {
#if defined(DAPPLE_LINUX)
        posix_spawn_file_actions_addclosefrom_np(&actions_, first);
#else
        (void)first;
#endif
    }
    const posix_spawn_file_actions_t* get() const {
        return &actions_;
    }

 private:
    posix_spawn_file_actions_t actions_;
};

// What a decoder is told of ours: where libraries are, what time it is, and in tests what is looked for. The
// rest is none of its business, least of all what people keep there for other programs to log in with.
std::vector<char*> decoder_environment() {
    std::vector<char*> environment;
    for (char** variable = environ; variable && *variable; ++variable) {
        const std::string_view text = *variable;
        for (const std::string_view name : {"LD_LIBRARY_PATH=", "TZ=", "ASAN_OPTIONS="})
            if (text.starts_with(name)) environment.push_back(*variable);
    }
    environment.push_back(nullptr);
    return environment;
}

// A decoder at work.
struct Process : Child {
    Process(const fs::path& program, const char* reader, const DecodeRequest& request,
            const Descriptor& file) {
        auto ends = own_pipe();
        if (!ends) throw DecodeError("cannot be read: " + reason(errno));
        output = std::move((*ends)[0]);
        const Descriptor input = above((*ends)[1]);
        const Descriptor given = above(file);
        Actions actions;
        actions.open(STDIN_FILENO, "/dev/null", O_RDONLY);
        // Libraries print there what they find wrong with a file, and it comes as a sentence too.
        actions.open(STDERR_FILENO, "/dev/null", O_WRONLY);
        actions.give(input, STDOUT_FILENO);
        actions.give(given, kPictureFile);
        actions.close_from(kPictureFile + 1);
        std::string name = program.string(), format = reader, most = std::to_string(request.most_pixels),
                    behind = request.over_paper ? "paper" : "black",
                    shape = request.square_pixels ? "square" : "as-is",
                    side = std::to_string(request.enough_side);
        std::array<char*, 7> arguments{name.data(),  format.data(), most.data(), behind.data(),
                                       shape.data(), side.data(),   nullptr};
        pid_t started = -1;  // of a failure nothing is to be ended
        const int error = ::posix_spawn(&started, name.c_str(), actions.get(), nullptr, arguments.data(),
                                        decoder_environment().data());
        if (error != 0) throw DecodeError("cannot be read: " + name + " does not start: " + reason(error));
        id = started;
    }
};

[[noreturn]] void fail_by(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU) throw DecodeError(kTooMuchTime);
        if (signal == SIGSYS)
            throw DecodeError(
                "cannot be read: its decoder asked the system for something that no picture needs, and was "
                "stopped");
        if (signal == SIGINT || signal == SIGTERM || signal == SIGKILL)
            throw DecodeError("cannot be read: its decoder was stopped");
        throw DecodeError(std::string("the picture is damaged: its decoder crashed (") + ::strsignal(signal) +
                          ")");
    }
    constexpr int kNotLoaded = 127;  // by the system
    if (WEXITSTATUS(status) == kNotLoaded)
        throw DecodeError(
            "cannot be read: the system does not load its decoder; too little memory or too few open files "
            "may be allowed here, or a library is missing");
    throw DecodeError("cannot be read: its decoder ended without an answer (exit " +
                      std::to_string(WEXITSTATUS(status)) + ")");
}

fs::path decoder_named(const char* name) {
#if defined(DAPPLE_LINUX)
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    const std::array places{folder, folder / "../libexec/dapple", folder / "../io"};
#else
    // A program that cannot tell where it lies cannot be moved.
    const std::array<fs::path, 2> places{DAPPLE_INSTALLED_DECODERS, DAPPLE_BUILT_DECODERS};
#endif
    for (const fs::path& place : places) {
        const fs::path decoder = place / name;
        if (::access(decoder.c_str(), X_OK) == 0) return decoder;
    }
    throw DecodeError("cannot be read: the program " + std::string(name) + " is missing from " +
                      places.front().string() + "; install or build dapple again");
}

void decode_open(const Descriptor& file, PictureFormat format, const fs::path& decoder,
                 const DecodeRequest& request, ImageSink& sink, const std::stop_token& stop = {},
                 const DecoderPatience& patience = {}) {
    Process process(decoder, std::string(reader_of(format)).c_str(), request, file);
    bool complete = false;
    {
        // Gone before the process is waited for: its number may then be another's.
        const std::stop_callback ending(stop, [&process] { process.end(); });
        complete = receive_image(process.output.get(), request, sink, patience);
    }
    if (complete) return;
    if (stop.stop_requested()) throw DecodeError("was not read to its end: it was stopped");
    fail_by(process.wait());
}

}  // namespace

fs::path decoder_for(PictureFormat format) {
    return decoder_named(format == PictureFormat::png   ? "dapple-decode-png"
                         : format == PictureFormat::jxl ? "dapple-decode-jxl"
                                                        : "dapple-decode");
}

void decode_file(const fs::path& path, const DecodeRequest& request, ImageSink& sink, std::stop_token stop) {
    const Descriptor file = open_file(path, stop);
    const PictureFormat format = format_in(file);
    decode_open(file, format, decoder_for(format), request, sink, stop);
}

void decode_file_smaller(const fs::path& path, const DecodeRequest& request, ImageSink& sink,
                         std::stop_token stop) {
    std::error_code ignored;
    // What comes through a pipe can be read once only.
    if (!fs::is_regular_file(path, ignored)) throw DecodeError("is not a file");
    const Descriptor file = open_file(path);
    const PictureFormat format = format_in(file);
    if (!may_hold_smaller(file, format)) throw DecodeError("is read as a whole only");
    const bool jpeg = format == PictureFormat::jpeg;
    decode_open(file, format, jpeg ? decoder_named("dapple-decode-jpeg") : decoder_for(format), request, sink,
                stop);
}

void decode_file_by(const fs::path& decoder, const fs::path& path, const DecodeRequest& request,
                    ImageSink& sink, const DecoderPatience& patience) {
    const Descriptor file = open_file(path);
    decode_open(file, format_in(file), decoder, request, sink, {}, patience);
}

}  // namespace dapple
