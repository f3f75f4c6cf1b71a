#include "app/viewer/desktop/dot_limit.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

#include "core/drawing/settings.h"

namespace dapple {
namespace {

// A dot is five floats and four bytes of colour in the drawing shown, in the one being placed and in one kept
// for its memory; all that twice in a split view, and once more while it is saved. Relaxing one needs 44
// bytes a dot for the while. The drawing as it was has some of the other half. The graphics driver gets them
// by and by.
constexpr std::uint64_t kBytesPerDot = 250;
constexpr std::uint64_t kShare = 2;  // one part in so many is for dots
constexpr std::uint64_t kFewest = 1'000'000;

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
    const std::uint64_t physical = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    std::uint64_t available = std::min(available_by_kernel().value_or(physical / 2), physical);
    const auto most = number_in("/sys/fs/cgroup/memory.max");
    const auto used = number_in("/sys/fs/cgroup/memory.current");
    if (most && used) available = std::min(available, *most - std::min(*used, *most));
    return available;
}

std::uint64_t most_dots_in(std::uint64_t bytes) {
    return std::clamp(bytes / kShare / kBytesPerDot, kFewest, kMostDots);
}

}  // namespace dapple
