#include "io/decoding/decoder_limits.h"

#include <sys/resource.h>

#include <algorithm>

namespace dapple {
namespace {

constexpr rlim_t kHeaderSeconds = 20;
constexpr rlim_t kBytesPerSecond = 1'000'000;  // slower than any format is decoded
constexpr rlim_t kOpenFiles = 64;

using Resource = decltype(RLIMIT_DATA);

// `for_good`: what the limit can be raised to later, where nobody is root.
void limit(Resource resource, rlim_t most, rlim_t for_good) {
    rlimit now{};
    if (getrlimit(resource, &now) != 0) return;
    now.rlim_max = std::min(for_good, now.rlim_max);
    now.rlim_cur = std::min(most, now.rlim_max);
    setrlimit(resource, &now);
}

void limit_memory(rlim_t pixel_bytes, rlim_t for_good) {
    // The sanitizers' own memory is counted too, terabytes of it.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    constexpr rlim_t kHeaderBytes = rlim_t{512} << 20;
    limit(RLIMIT_DATA, kHeaderBytes + 2 * pixel_bytes, kHeaderBytes + 2 * for_good);
#else
    (void)pixel_bytes, (void)for_good;
#endif
}

void limit_time(rlim_t pixel_bytes, rlim_t for_good) {
    // The first limit says what happened, the one for good just ends the process.
    constexpr rlim_t kBetween = 5;
    limit(RLIMIT_CPU, kHeaderSeconds + pixel_bytes / kBytesPerSecond,
          kHeaderSeconds + for_good / kBytesPerSecond + kBetween);
}

}  // namespace

std::uint64_t most_pixel_bytes(std::int64_t most_pixels) {
    constexpr std::int64_t kMostOfAPixel = 32;  // eight channels of floats
    return static_cast<std::uint64_t>(std::min(most_pixels, INT64_MAX / (4 * kMostOfAPixel)) * kMostOfAPixel);
}

void limit_decoder(std::int64_t most_pixels) {
    const rlim_t most = most_pixel_bytes(most_pixels);
    limit_memory(0, most);
    limit_time(0, most);
    limit(RLIMIT_FSIZE, 0, 0);
    limit(RLIMIT_NOFILE, kOpenFiles, kOpenFiles);
    limit(RLIMIT_CORE, 0, 0);
}

void limit_decoder_to(const PixelBytes& pixels) {
    limit_memory(pixels.in_memory, pixels.in_memory);
    limit_time(pixels.in_all, pixels.in_all);
}

void limit_decoder_memory(std::uint64_t pixel_bytes) {
    limit_memory(pixel_bytes, RLIM_INFINITY / 4);
}

}  // namespace dapple
