// What core has of kissfft, in the names of its C functions, by its header for C++: of the others Debian has
// the headers alone, and a library for its own processors.
#pragma once
#include <cstddef>
#include <kissfft.hh>

struct kiss_fft_cpx {
    float r, i;
};
struct kiss_fft_state {
    kissfft<float> transform;
    std::size_t size;
};
using kiss_fftr_state = kiss_fft_state;

inline kiss_fft_state* kiss_fft_alloc(int size, int inverse, void*, std::size_t*) {
    const auto numbers = static_cast<std::size_t>(size);
    return new kiss_fft_state{kissfft<float>(numbers, inverse != 0), numbers};
}
inline kiss_fftr_state* kiss_fftr_alloc(int size, int inverse, void*, std::size_t*) {
    return kiss_fft_alloc(size / 2, inverse, nullptr, nullptr);
}
inline void kiss_fft_free(void* state) {
    delete static_cast<kiss_fft_state*>(state);
}
inline void kiss_fft(const kiss_fft_state* state, const kiss_fft_cpx* from, kiss_fft_cpx* to) {
    state->transform.transform(reinterpret_cast<const std::complex<float>*>(from),
                               reinterpret_cast<std::complex<float>*>(to));
}
// The first and the last sum are real, and kissfft.hh has both in one.
inline void kiss_fftr(const kiss_fftr_state* state, const float* from, kiss_fft_cpx* to) {
    state->transform.transform_real(from, reinterpret_cast<std::complex<float>*>(to));
    to[state->size] = {to[0].i, 0};
    to[0].i = 0;
}

/// The next even one of which half has no prime factors above 5.
inline int kiss_fftr_next_fast_size_real(int least) {
    int half = (least + 1) / 2;
    for (;; ++half) {
        int rest = half;
        for (const int factor : {2, 3, 5})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return 2 * half;
    }
}
