#include "io/files/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#if defined(DAPPLE_LINUX)
#include <sys/vfs.h>
#endif

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = ".dapple-", kEnd = ".part";
constexpr std::size_t kDigits = 8;
constexpr std::time_t kDay = 24 * 60 * 60;

bool is_name_of_part(std::string_view name) {
    if (name.size() != kBegin.size() + kDigits + kEnd.size()) return false;
    if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return false;
    return name.substr(kBegin.size(), kDigits).find_first_not_of("0123456789abcdef") == name.npos;
}

// Whether a file still has the name that it was opened by.
bool has_name(const Descriptor& file, const fs::path& name) {
    struct stat opened {
    }, named{};
    return ::fstat(file.get(), &opened) == 0 && ::lstat(name.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

// File systems that other machines write to as well: NFS, SMB in three ages, Ceph, AFS, Plan 9 and FUSE,
// which sshfs and folders shared with virtual machines come by. The numbers are those of Linux's statfs(2);
// elsewhere, any may be such.
bool is_remote([[maybe_unused]] const Descriptor& file) {
#if defined(DAPPLE_LINUX)
    constexpr std::array<std::uint32_t, 8> kRemote{0x6969,     0x517b,     0xff534d42, 0xfe534d42,
                                                   0x00c36400, 0x5346414f, 0x01021997, 0x65735546};
    struct statfs system {};
    if (::fstatfs(file.get(), &system) != 0) return true;
    return std::ranges::count(kRemote, static_cast<std::uint32_t>(system.f_type)) > 0;
#else
    return true;
#endif
}

// The time now where the folder is; none if nothing can be made there.
std::optional<std::time_t> time_of_server(const fs::path& folder) {
    struct stat made {};
#if defined(O_TMPFILE)
    const Descriptor file(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600));
    if (file && ::fstat(file.get(), &made) == 0) return made.st_mtime;
        // Network file systems seldom have such files.
#endif
    try {
        const PartFile part(folder / "any");
        if (::fstat(part.descriptor(), &made) == 0) return made.st_mtime;
    } catch (const std::runtime_error&) {
    }
    return std::nullopt;
}

bool is_abandoned(const Descriptor& file, const fs::path& folder) {
    // No waiting: who holds the lock is at work.
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return false;
    struct stat found {};
    if (::fstat(file.get(), &found) != 0 || !S_ISREG(found.st_mode) || found.st_uid != ::geteuid())
        return false;
    if (!is_remote(file)) return true;
    const std::optional<std::time_t> now = time_of_server(folder);
    return now && *now - found.st_mtime > kDay;
}

}  // namespace

PartFile::PartFile(const fs::path& target) {
    std::random_device random;
    for (;;) {
        fs::path name = target;
        name.replace_filename(fmt::format("{}{:0{}x}{}", kBegin, random(), kDigits, kEnd));
        name_.emplace(name);
        file_ = Descriptor(name_->make());
        if (!file_) {
            const int error = errno;
            name_->keep();  // not ours
            if (error == EEXIST) continue;
            throw std::system_error(error, std::generic_category());
        }
        // Between the two, somebody who tidies up may have taken it for abandoned. File systems without locks
        // fail here, and for who tidies up too.
        const bool taken = ::flock(file_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        if (!taken && has_name(file_, name)) return;
    }
}

int PartFile::rename_to(const fs::path& target) {
    // Not closed before: without its lock, it would be taken for abandoned.
    if (::rename(path(), target.c_str()) != 0) return errno;
    name_->keep();
    return 0;
}

void remove_abandoned_parts(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        if (!is_name_of_part(path.filename().native())) continue;
        const Descriptor file(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        // Who wrote it may have given it its name since, and let go of it.
        if (file && is_abandoned(file, folder) && has_name(file, path)) ::unlink(path.c_str());
    }
}

}  // namespace dapple
