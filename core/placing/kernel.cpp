#include "core/placing/kernel.h"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace dapple {

#if defined(DAPPLE_WIDE_KERNELS)
extern const Kernels kAvx2Kernels, kAvx512Kernels;
#endif

namespace {

const Kernels& choose() {
    const std::vector<const Kernels*> kernels = runnable_kernels();
    const char* const wanted = std::getenv("DAPPLE_KERNELS");
    if (!wanted) return *kernels.back();
    std::vector<std::string_view> names;
    for (const Kernels* each : kernels) {
        if (std::string_view(wanted) == each->name) return *each;
        names.emplace_back(each->name);
    }
    throw std::runtime_error(
        fmt::format("DAPPLE_KERNELS: {} is not known, or not for this processor; it runs {}", wanted,
                    fmt::join(names, ", ")));
}

}  // namespace

std::vector<const Kernels*> runnable_kernels() {
    std::vector<const Kernels*> kernels{&kPlainKernels};
#if defined(DAPPLE_WIDE_KERNELS)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) kernels.push_back(&kAvx2Kernels);
    if (__builtin_cpu_supports("avx512f")) kernels.push_back(&kAvx512Kernels);
#endif
    return kernels;
}

const Kernels& chosen_kernels() {
    static const Kernels& chosen = choose();
    return chosen;
}

}  // namespace dapple
