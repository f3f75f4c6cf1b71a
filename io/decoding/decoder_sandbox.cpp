#include "io/decoding/decoder_sandbox.h"

#if defined(DAPPLE_LINUX)
#include <fcntl.h>
#include <linux/capability.h>
#include <linux/landlock.h>
#include <poll.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <memory>
#include <system_error>
#endif

namespace dapple {

#if defined(DAPPLE_LINUX)

namespace {

// 0, or why not all is done that is to be done before libraries are initialised. By numbers alone: nothing is
// set up yet where it is written.
int early_error = 0;

void allow_reading(int rules, int place, bool folder) {
    landlock_path_beneath_attr rule{};
    rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE | (folder ? LANDLOCK_ACCESS_FS_READ_DIR : 0);
    rule.parent_fd = place;
    // What has no name anywhere, such as memory, cannot have a rule, and needs none.
    ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

void allow_reading(int rules, const char* path, bool folder) {
    const int place = ::open(path, O_PATH | O_CLOEXEC);
    if (place < 0) return;  // nor can anybody read it
    allow_reading(rules, place, folder);
    ::close(place);
}

// Root may raise limits, and more. But root's programs may also read other people's pictures: the kernel
// looks once more whether they may when a library opens one by the name of its descriptor. That they may read
// whatever they like stays only where no other file can be opened.
void drop_privileges(bool other_files_shut_out) {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct privileges[_LINUX_CAPABILITY_U32S_3]{};
    if (::syscall(SYS_capget, &header, privileges) != 0) {
        early_error = errno;
        return;
    }
    const std::uint32_t kept = other_files_shut_out ? 1U << CAP_DAC_READ_SEARCH : 0;
    privileges[0] = {privileges[0].effective & kept, privileges[0].permitted & kept, 0};
    privileges[1] = {};
    if (::syscall(SYS_capset, &header, privileges) != 0) early_error = errno;
}

// False if the kernel has no Landlock, or whoever runs this system.
bool shut_files_out() {
    landlock_ruleset_attr handled{};
    handled.handled_access_fs =
        LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
        LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
        LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
        LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
        LANDLOCK_ACCESS_FS_MAKE_SYM;
    const auto rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    if (rules < 0) return false;
    allow_reading(rules, kPictureFile, false);
    for (const char* const file : {"/etc/localtime", "/etc/ld.so.cache"}) allow_reading(rules, file, false);
    // Libraries: that of HEIC in Debian 13 loads its codecs when a file needs one.
    for (const char* const folder :
         {"/usr/share/zoneinfo", "/sys/devices/system/cpu", "/sys/devices/system/node", "/usr/lib"})
        allow_reading(rules, folder, true);
    if (::syscall(SYS_landlock_restrict_self, rules, 0) != 0) early_error = errno;
    ::close(rules);
    return true;
}

// What binds only the thread that asks for it, and those that it starts.
void begin_early(int, char**, char**) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) early_error = errno;
    drop_privileges(shut_files_out());
}

// The system calls these before it initialises any library.
using Early = void (*)(int, char**, char**);
__attribute__((section(".preinit_array"), used)) const Early before_libraries = &begin_early;

void expect(bool done, int error) {
    if (done) return;
    throw NoSandbox("cannot be read: the system does not shut its decoder in: " +
                    std::generic_category().message(error));
}

class Filter {
 public:
    Filter() : filter_(seccomp_init(SCMP_ACT_KILL_PROCESS), &seccomp_release) {
        expect(filter_ != nullptr, ENOMEM);
        // Threads that libraries have started too.
        expect_set(seccomp_attr_set(filter_.get(), SCMP_FLTATR_CTL_TSYNC, 1));
    }

    void allow(int call) { rule(SCMP_ACT_ALLOW, call); }
    void allow_if(int call, const scmp_arg_cmp& condition) {
        expect_set(seccomp_rule_add(filter_.get(), SCMP_ACT_ALLOW, call, 1, condition));
    }
    void fail_with(int error, int call) { rule(SCMP_ACT_ERRNO(static_cast<unsigned>(error)), call); }
    void begin() { expect_set(seccomp_load(filter_.get())); }

 private:
    // Calls that this processor's Linux has not are left out by the library.
    void rule(std::uint32_t action, int call) {
        expect_set(seccomp_rule_add(filter_.get(), action, call, 0));
    }
    static void expect_set(int result) { expect(result >= 0, -result); }

    std::unique_ptr<void, decltype(&seccomp_release)> filter_;
};

}  // namespace

void end_with_parent(int pipe) {
    // The parent's thread is meant, which waits for this process anyway.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // A parent's files are closed before its children are told.
    pollfd end{.fd = pipe, .events = 0, .revents = 0};
    if (::poll(&end, 1, 0) > 0 && (end.revents & POLLERR) != 0) ::_exit(0);
}

void enter_sandbox() {
    expect(early_error == 0, early_error);
    expect(::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) == 0, errno);

    Filter filter;
    // As traced of all formats, on Debian 12 and 13; some have other names on processors of 32 bits.
    for (const int call :
         {SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(lseek), SCMP_SYS(_llseek),
          SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(close), SCMP_SYS(dup), SCMP_SYS(fstat),
          SCMP_SYS(fstat64), SCMP_SYS(newfstatat), SCMP_SYS(fstatat64), SCMP_SYS(stat), SCMP_SYS(lstat),
          SCMP_SYS(getdents64), SCMP_SYS(fadvise64)})
        filter.allow(call);
    // Memory, and threads that share it; sigaltstack is for those of sanitizers.
    for (const int call : {SCMP_SYS(mmap),
                           SCMP_SYS(mmap2),
                           SCMP_SYS(munmap),
                           SCMP_SYS(mprotect),
                           SCMP_SYS(mremap),
                           SCMP_SYS(madvise),
                           SCMP_SYS(brk),
                           SCMP_SYS(futex),
                           SCMP_SYS(futex_time64),
                           SCMP_SYS(set_robust_list),
                           SCMP_SYS(rseq),
                           SCMP_SYS(set_tid_address),
                           SCMP_SYS(sched_getaffinity),
                           SCMP_SYS(sched_yield),
                           SCMP_SYS(getcpu),
                           SCMP_SYS(nanosleep),
                           SCMP_SYS(clock_nanosleep),
                           SCMP_SYS(clock_nanosleep_time64),
                           SCMP_SYS(rt_sigprocmask),
                           SCMP_SYS(sigaltstack),
                           SCMP_SYS(restart_syscall),
                           SCMP_SYS(exit),
                           SCMP_SYS(exit_group)})
        filter.allow(call);
    // What the system and the time are.
    for (const int call :
         {SCMP_SYS(sysinfo), SCMP_SYS(uname), SCMP_SYS(getrandom), SCMP_SYS(clock_gettime),
          SCMP_SYS(clock_gettime64), SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(gettid),
          SCMP_SYS(getpid), SCMP_SYS(getppid), SCMP_SYS(getuid), SCMP_SYS(geteuid), SCMP_SYS(getgid),
          SCMP_SYS(getegid), SCMP_SYS(getrlimit), SCMP_SYS(ugetrlimit), SCMP_SYS(getrusage)})
        filter.allow(call);
    constexpr scmp_datum_t kWriting = O_ACCMODE | O_CREAT | O_TRUNC;
    filter.allow_if(SCMP_SYS(openat), {2, SCMP_CMP_MASKED_EQ, kWriting, O_RDONLY});
    filter.allow_if(SCMP_SYS(open), {1, SCMP_CMP_MASKED_EQ, kWriting, O_RDONLY});
    filter.allow_if(SCMP_SYS(fcntl), {1, SCMP_CMP_EQ, F_GETFL, 0});
    filter.allow_if(SCMP_SYS(fcntl64), {1, SCMP_CMP_EQ, F_GETFL, 0});
    // Its own, which are final: what it lowers it cannot raise again.
    filter.allow_if(SCMP_SYS(prlimit64), {0, SCMP_CMP_EQ, 0, 0});
    filter.allow(SCMP_SYS(setrlimit));
    filter.allow_if(SCMP_SYS(tgkill), {0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid()), 0});
    filter.allow_if(SCMP_SYS(prctl), {0, SCMP_CMP_EQ, PR_SET_NAME, 0});
    filter.allow_if(SCMP_SYS(prctl), {0, SCMP_CMP_EQ, PR_SET_VMA, 0});  // a name for memory
    filter.allow_if(SCMP_SYS(clone), {0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD});
    // Whose flags lie in memory, where a filter cannot look: the C library then asks as above.
    filter.fail_with(ENOSYS, SCMP_SYS(clone3));
    filter.fail_with(ENOSYS, SCMP_SYS(statx));
    filter.fail_with(ENOTTY, SCMP_SYS(ioctl));
    // What libraries ask and can do without.
    for (const int call : {SCMP_SYS(access), SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(readlink),
                           SCMP_SYS(readlinkat), SCMP_SYS(getcwd), SCMP_SYS(get_mempolicy)})
        filter.fail_with(EACCES, call);
    filter.begin();
}

#else

void end_with_parent(int) {}

void enter_sandbox() {}

#endif

}  // namespace dapple
