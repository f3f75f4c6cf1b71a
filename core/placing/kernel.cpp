#include "core/placing/kernel.h"

namespace dapple {

Kernel best_kernel() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f")) return place_square_avx512;
    if (__builtin_cpu_supports("avx2")) return place_square_avx2;
#endif
    return place_square_baseline;
}

}  // namespace dapple
