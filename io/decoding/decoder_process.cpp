#include "io/decoding/decoder_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/decoding/decoder_sandbox.h"
#include "io/decoding/image_pipe.h"
#include "io/decoding/kept_input.h"
#include "io/decoding/tiff_page.h"
#include "io/descriptor.h"

extern char** environ;

namespace dapple {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
    return std::generic_category().message(error);
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
    Actions(const Actions&) = delete;
    Actions& operator=(const Actions&) = delete;
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
class Process {
 public:
    Process(const fs::path& program, const char* reader, const DecodeRequest& request,
            const Descriptor& file) {
        auto ends = own_pipe();
        if (!ends) throw DecodeError("cannot be read: " + reason(errno));
        output_ = std::move((*ends)[0]);
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
        const int error = ::posix_spawn(&id_, name.c_str(), actions.get(), nullptr, arguments.data(),
                                        decoder_environment().data());
        if (error != 0) throw DecodeError("cannot be read: " + name + " does not start: " + reason(error));
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (id_ <= 0) return;
        end();
        wait();
    }

    int output() const { return output_.get(); }

    /// Its pipe ends soon after.
    void end() const { ::kill(id_, SIGKILL); }

    /// Its status, as waitpid() tells it.
    int wait() {
        int status = 0;
        while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
        id_ = -1;
        return status;
    }

 private:
    Descriptor output_;
    pid_t id_ = -1;
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
    throw DecodeError("cannot be read: its decoder ended without a word (exit " +
                      std::to_string(WEXITSTATUS(status)) + ")");
}

}  // namespace

namespace {

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
        complete = receive_image(process.output(), request, sink, patience);
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
