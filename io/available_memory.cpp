#include "io/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "core/failure.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

std::optional<std::uint64_t> number_in(const char* file) {
    std::uint64_t number = 0;
    if (std::ifstream(file) >> number) return number;
    return std::nullopt;
}

std::optional<std::uint64_t> available_by_kernel() {
    std::ifstream lines("/proc/meminfo");
    std::string name, unit;
    for (std::uint64_t kilobytes = 0; lines >> name >> kilobytes; std::getline(lines, unit))
        if (name == "MemAvailable:") return kilobytes * 1024;
    return std::nullopt;
}

}  // namespace

std::uint64_t available_memory() {
    const auto pages = static_cast<std::uint64_t>(std::max(sysconf(_SC_PHYS_PAGES), 0L));
    const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    const std::uint64_t physical = pages * page;
    std::uint64_t available = std::min(available_by_kernel().value_or(physical / 2), physical);
    const auto most = number_in("/sys/fs/cgroup/memory.max");
    const auto used = number_in("/sys/fs/cgroup/memory.current");
    if (most && used) available = std::min(available, *most - std::min(*used, *most));
    rlimit limit{};
    std::uint64_t own_pages = 0;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
        std::ifstream("/proc/self/statm") >> own_pages)
        available =
            std::min(available, limit.rlim_cur - std::min<std::uint64_t>(own_pages * page, limit.rlim_cur));
    return available;
}

void check_memory(double bytes, std::string_view what, const std::optional<double>& allowed) {
    const double there = allowed.value_or(static_cast<double>(available_memory()));
    if (bytes <= there) return;
    throw failure(
        "{} would need about {} of memory, and {} are {}; choose fewer, or try with --memory {:.0f}G", what,
        bytes_in_words(bytes), bytes_in_words(there), allowed ? "allowed" : "available",
        std::ceil(bytes / 1e9));
}

}  // namespace dapple
