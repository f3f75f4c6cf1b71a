#pragma once
// Memory for columns of many numbers.

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace dapple {

inline constexpr std::size_t kLargeMemory = 4 << 20;

/// Memory of kLargeMemory and more, in huge pages where it is Linux that has them: there, fresh memory and
/// writing through a hundred megabytes cost less. Throws std::bad_alloc.
void* allocate_large(std::size_t bytes);
void deallocate_large(void* memory);

/// Leaves numbers unset when a vector grows: a million dots a frame are written once, not twice.
template <class T>
struct UnsetAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    T* allocate(std::size_t count) {
        if (count < kLargeMemory / sizeof(T)) return std::allocator<T>::allocate(count);
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocate_large(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) {
        if (count < kLargeMemory / sizeof(T)) return std::allocator<T>::deallocate(memory, count);
        deallocate_large(memory);
    }
    template <class U>
    void construct(U* place) noexcept {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }
};
using FloatBuffer = std::vector<float, UnsetAllocator<float>>;

}  // namespace dapple
