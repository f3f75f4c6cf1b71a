#include "core/placing/kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string_view>

namespace dapple {

#if defined(DAPPLE_WIDE_KERNELS)
extern const Kernels kAvx2Kernels, kAvx512Kernels;
#endif

namespace {

std::atomic<const Kernels*> chosen = nullptr;  // none: the widest

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
    static const Kernels& widest = *runnable_kernels().back();
    const Kernels* const by_name = chosen;
    return by_name ? *by_name : widest;
}

void choose_kernels(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Kernels* each : runnable_kernels()) {
        names.emplace_back(each->name);
        if (name == each->name) chosen = each;
    }
    if (std::ranges::find(names, name) == names.end())
        throw std::runtime_error(fmt::format("{}: not known, or not for this processor, which runs {}", name,
                                             fmt::join(names, ", ")));
}

}  // namespace dapple
