#include "core/placing/kernel.h"

namespace dapple {

const Kernels& best_kernels() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f")) return kAvx512Kernels;
    if (__builtin_cpu_supports("avx2")) return kAvx2Kernels;
#endif
    return kBaselineKernels;
}

}  // namespace dapple
