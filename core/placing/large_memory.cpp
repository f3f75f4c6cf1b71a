#include "core/placing/large_memory.h"

#if defined(DAPPLE_LINUX)
#include <sys/mman.h>
#endif

namespace dapple {

namespace {

constexpr std::align_val_t kHugePage{2 << 20};

}  // namespace

void* allocate_large(std::size_t bytes) {
    void* const memory = ::operator new(bytes, kHugePage);
#if defined(DAPPLE_LINUX)
    madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: without, it is memory as well
#endif
    return memory;
}

void deallocate_large(void* memory) {
    ::operator delete(memory, kHugePage);
}

}  // namespace dapple
