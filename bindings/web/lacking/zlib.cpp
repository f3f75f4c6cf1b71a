#include "zlib.h"

#include <cstdlib>
#include <cstring>

#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

uLong compressBound(uLong size) {
    return size + size / 100 + 64;
}

int compress2(Bytef* to, uLongf* size, const Bytef* from, uLong from_size, int level) {
    int packed = 0;
    unsigned char* const bytes =
        stbi_zlib_compress(const_cast<Bytef*>(from), static_cast<int>(from_size), &packed, level);
    const bool fits = bytes && static_cast<uLong>(packed) <= *size;
    if (fits) {
        std::memcpy(to, bytes, static_cast<std::size_t>(packed));
        *size = static_cast<uLongf>(packed);
    }
    std::free(bytes);
    return fits ? Z_OK : -1;
}

int uncompress(Bytef* to, uLongf* size, const Bytef* from, uLong from_size) {
    const int read =
        stbi_zlib_decode_buffer(reinterpret_cast<char*>(to), static_cast<int>(*size),
                                reinterpret_cast<const char*>(from), static_cast<int>(from_size));
    if (read < 0) return -1;
    *size = static_cast<uLongf>(read);
    return Z_OK;
}
