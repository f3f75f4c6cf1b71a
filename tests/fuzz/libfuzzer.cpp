// A reader for libFuzzer: DAPPLE_READ is its call.

#include <cstddef>
#include <cstdint>
#include <string>

#include DAPPLE_READER

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    DAPPLE_READ;
    return 0;
}
