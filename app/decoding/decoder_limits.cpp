#include "app/decoding/decoder_limits.h"

#include <sys/resource.h>

#include <algorithm>

namespace dapple {
namespace {

constexpr rlim_t kHeaderSeconds = 20;
constexpr rlim_t kBytesPerSecond = 1'000'000;  // slower than any format is decoded
constexpr rlim_t kOpenFiles = 64;

void limit(decltype(RLIMIT_DATA) resource, rlim_t most) {
    rlimit now{};
    if (getrlimit(resource, &now) != 0) return;
    now.rlim_cur = std::min(most, now.rlim_max);
    setrlimit(resource, &now);
}

}  // namespace

void limit_decoder_memory(std::uint64_t pixel_bytes) {
    // The sanitizers' own memory is counted too, terabytes of it.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    constexpr rlim_t kHeaderBytes = rlim_t{512} << 20;
    limit(RLIMIT_DATA, kHeaderBytes + 2 * rlim_t{pixel_bytes});
#else
    (void)pixel_bytes;
#endif
}

void limit_decoder() {
    limit_decoder_memory(0);
    limit(RLIMIT_CPU, kHeaderSeconds);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NOFILE, kOpenFiles);
    limit(RLIMIT_CORE, 0);
}

void limit_decoder_to(std::uint64_t pixel_bytes) {
    limit_decoder_memory(pixel_bytes);
    limit(RLIMIT_CPU, kHeaderSeconds + rlim_t{pixel_bytes} / kBytesPerSecond);
}

}  // namespace dapple
