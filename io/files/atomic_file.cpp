#include "io/files/atomic_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <thread>

#include "core/failure.h"
#include "io/descriptor.h"
#include "io/signals.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::string reason(int error) {
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "the disk is full";
        case EFBIG:
            return "the file grew beyond the size that is allowed here";
        case EPIPE:
            return "the program that read it has ended or stopped reading";
        default:
            return std::generic_category().message(error);
    }
}

[[noreturn]] void fail(const fs::path& target, std::string_view what) {
    throw failure("{}: {}", target.string(), what);
}

[[noreturn]] void fail_to_write(const fs::path& target, int error) {
    fail(target, fmt::format("cannot be written: {}", reason(error)));
}

// A file that is being written beside the one that it is going to replace. Where the system has files without
// a name (Linux, on its own file systems) it has none until it is whole, and nothing is left of it whatever
// ends the program. Elsewhere its name is hidden, ".dapple-1a2b3c4d.part".
class PartFile {
 public:
    explicit PartFile(const fs::path& target) : target_(target) {
#if defined(O_TMPFILE)
        file_ = Descriptor(::open(folder_of(target).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666));
        // It gets its name by that of its descriptor.
        if (file_ && ::access(name_of_descriptor().c_str(), F_OK) == 0) return;
#endif
        take_name([&](const char* name) {
            file_ = Descriptor(::open(name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
            return static_cast<bool>(file_);
        });
    }
    PartFile& operator=(PartFile&&) = delete;
    ~PartFile() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }

    int descriptor() const {
        return file_.get();
    }

    /// Takes the place and the name of the target.
    void finish() {
        // A name is given only where there is none yet.
        const auto link = [&](const char* name) {
            return ::linkat(AT_FDCWD, name_of_descriptor().c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
        };
        if (name_.empty()) {
            if (link(target_.c_str())) return;
            take_name(link);
        }
        if (::rename(name_.c_str(), target_.c_str()) != 0) fail_to_write(target_, errno);
        name_.clear();
    }

 private:
    std::string name_of_descriptor() const {
        return fmt::format("/proc/self/fd/{}", file_.get());
    }

    // A new one, that make(name) gives it: false and errno if it cannot, or if there is such a file.
    template <class Make>
    void take_name(const Make& make) {
        std::random_device random;
        fs::path name = target_;
        do {
            name.replace_filename(fmt::format(".dapple-{:08x}.part", random()));
            if (make(name.c_str())) {
                name_ = name;
                return;
            }
        } while (errno == EEXIST);
        fail_to_write(target_, errno);
    }

    const fs::path& target_;
    Descriptor file_;
    fs::path name_;  // empty: none
};

// A file descriptor as a stream. Exceptions leave it through the stream, which has them switched on.
class DescriptorBuffer : public std::streambuf {
 public:
    DescriptorBuffer(int descriptor, const fs::path& target, bool can_go_back)
        : descriptor_(descriptor), target_(target), can_go_back_(can_go_back), buffer_(std::size_t{1} << 18) {
        setp(buffer_.data(), buffer_.data() + buffer_.size());
    }

 private:
    int_type overflow(int_type c) override {
        write_out();
        if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
    }

    int sync() override {
        write_out();
        return 0;
    }

    // Places in a file, for writers that go back. A pipe has none.
    pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode) override {
        if (!can_go_back_) return pos_type(off_type(-1));
        const bool tell = from == std::ios::cur && offset == 0;
        if (tell) return pos_type(::lseek(descriptor_, 0, SEEK_CUR) + (pptr() - pbase()));
        write_out();
        const int whence = from == std::ios::beg ? SEEK_SET : from == std::ios::cur ? SEEK_CUR : SEEK_END;
        return pos_type(::lseek(descriptor_, offset, whence));
    }
    pos_type seekpos(pos_type place, std::ios::openmode mode) override {
        return seekoff(off_type(place), std::ios::beg, mode);
    }

    void write_out() {
        const char* from = pbase();
        while (from != pptr()) {
            const ssize_t written = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) {
                const int error = errno;
                setp(buffer_.data(), buffer_.data() + buffer_.size());
                fail_to_write(target_, error);
            }
            from += written;
        }
        setp(buffer_.data(), buffer_.data() + buffer_.size());
    }

    int descriptor_;
    const fs::path& target_;
    bool can_go_back_;
    std::vector<char> buffer_;
};

enum class GoingBack { possible, impossible };

void write_through(int descriptor, const fs::path& target, GoingBack back,
                   const std::function<void(std::ostream&)>& write) {
    const WriteErrorsInsteadOfSignals errors;
    DescriptorBuffer buffer(descriptor, target, back == GoingBack::possible);
    std::ostream out(&buffer);
    out.exceptions(std::ios::badbit | std::ios::failbit);
    write(out);
    out.flush();
}

// Waiting for the one who reads a pipe may take for ever, and nobody could stop it.
Descriptor open_for_reader(const fs::path& target) {
    constexpr std::chrono::milliseconds kBetweenLooks(20), kPatience(5000);
    const auto begin = std::chrono::steady_clock::now();
    Descriptor file;
    while (!(file = Descriptor(::open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)))) {
        if (errno != ENXIO) fail_to_write(target, errno);
        if (std::chrono::steady_clock::now() - begin > kPatience)
            fail(target, "cannot be written: it is a pipe, and no program reads from it");
        std::this_thread::sleep_for(kBetweenLooks);
    }
    ::fcntl(file.get(), F_SETFL, ::fcntl(file.get(), F_GETFL) & ~O_NONBLOCK);
    return file;
}

void write_directly(const fs::path& target, const std::function<void(std::ostream&)>& write) {
    Descriptor file = open_for_reader(target);
    write_through(file.get(), target, GoingBack::impossible, write);
    if (file.close() != 0) fail_to_write(target, errno);
}

void write_beside(const fs::path& target, const std::function<void(std::ostream&)>& write) {
    struct stat old {};
    const bool replaces = ::stat(target.c_str(), &old) == 0;
    PartFile part(target);
    if (replaces) {
        // It stays its owner's where that may be. What runs with its owner's rights would run with the
        // writer's.
        if (::fchown(part.descriptor(), old.st_uid, old.st_gid) != 0)
            static_cast<void>(::fchown(part.descriptor(), static_cast<uid_t>(-1), old.st_gid));
        static_cast<void>(::fchmod(part.descriptor(), old.st_mode & 0777));
    }

    write_through(part.descriptor(), target, GoingBack::possible, write);
    if (::fsync(part.descriptor()) != 0) fail_to_write(target, errno);
    part.finish();

    // The new name is safe only once the folder is on disk too; some file systems cannot do it, and need not.
    const Descriptor folder(::open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder) static_cast<void>(::fsync(folder.get()));
}

// The file that a name leads to, through links, there already or not. Throws if they lead nowhere.
fs::path destination_of(const fs::path& target) {
    constexpr int kMostLinks = 40;  // as the system has it
    std::error_code error;
    if (fs::exists(fs::status(target, error))) {
        const bool link = fs::is_symlink(fs::symlink_status(target, error));
        fs::path resolved = link ? fs::canonical(target, error) : target;
        return error ? target : resolved;
    }
    fs::path place = target;
    for (int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
        const fs::path next = fs::read_symlink(place, error);
        if (error || links == kMostLinks)
            fail(target, "is a link that leads to itself; remove it or choose another name");
        place = place.parent_path() / next;
    }
    return place;
}

// A file's place on the disk, which all its names and links share; its one name if it is not there yet.
// Nothing for a pipe or a device. "-" is the standard input of what is read, or output of what is written.
std::optional<std::string> identity_of(const fs::path& file, int standard) {
    struct stat status;
    if ((file == "-" ? ::fstat(standard, &status) : ::stat(file.c_str(), &status)) == 0) {
        if (!S_ISREG(status.st_mode)) return std::nullopt;
        return fmt::format("{}:{}", status.st_dev, status.st_ino);
    }
    std::error_code error;
    const fs::path absolute = fs::absolute(destination_of(file), error);
    const fs::path canonical = fs::weakly_canonical(absolute, error);
    return (error ? absolute.lexically_normal() : canonical).string();
}

}  // namespace

void check_apart(const std::vector<FileInUse>& written, const std::vector<FileInUse>& read) {
    std::map<std::string, std::string> in_use;
    for (const FileInUse& file : read)
        if (const auto identity = identity_of(file.path, STDIN_FILENO)) in_use.emplace(*identity, file.what);
    for (const FileInUse& file : written) {
        const auto identity = identity_of(file.path, STDOUT_FILENO);
        if (!identity) continue;
        const auto [there, is_new] = in_use.emplace(*identity, file.what);
        if (!is_new)
            fail(file.path, fmt::format("would be written over {}; choose another name", there->second));
    }
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (fs::is_directory(status)) return;
    if (fs::exists(status)) fail(folder, "is a file, not a folder; name a folder");
    fs::create_directories(folder, error);
    if (error) fail(folder, fmt::format("the folder cannot be made: {}", error.message()));
}

void check_can_save(const fs::path& target) {
    std::error_code error;
    const fs::path destination = destination_of(target);
    const fs::file_status status = fs::status(destination, error);
    if (fs::is_directory(status)) fail(target, "is a folder; name a file in it");
    if (fs::exists(status)) {
        if (::access(destination.c_str(), W_OK) != 0) fail(target, "is read-only; choose another name");
        if (!fs::is_regular_file(status)) return;
    }
    const fs::path folder = folder_of(destination);
    const fs::file_status folder_status = fs::status(folder, error);
    if (!fs::exists(folder_status)) {
        fail(target, fmt::format("the folder {} does not exist; make it first", folder.string()));
    }
    if (!fs::is_directory(folder_status))
        fail(target, fmt::format("{} is a file, not a folder", folder.string()));
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        fail(target, fmt::format("the folder {} is read-only; choose another", folder.string()));
    }
}

void save_next(std::size_t before, const std::function<void()>& save) {
    try {
        save();
    } catch (const std::runtime_error& error) {
        if (before == 0) throw;
        throw failure("{}; {} before it {} saved, and {}", error.what(),
                      before == 1 ? "the one" : fmt::format("the {}", before), before == 1 ? "is" : "are",
                      before == 1 ? "stays" : "stay");
    }
}

void write_to_standard_output(const std::function<void(std::ostream&)>& write) {
    write_through(STDOUT_FILENO, "the standard output", GoingBack::impossible, write);
}

void save_atomically(const fs::path& target, const std::function<void(std::ostream&)>& write) {
    check_can_save(target);
    const fs::path destination = destination_of(target);
    std::error_code error;
    const fs::file_status status = fs::status(destination, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        write_directly(destination, write);
    else
        write_beside(destination, write);
}

}  // namespace dapple
