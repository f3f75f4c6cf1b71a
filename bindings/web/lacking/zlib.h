// What core has of zlib, for masks: as little as stb_image and stb_image_write have of it.
#pragma once
using Bytef = unsigned char;
using uLong = unsigned long;
using uLongf = uLong;
inline constexpr int Z_OK = 0, Z_BEST_COMPRESSION = 9;

uLong compressBound(uLong size);
int compress2(Bytef* to, uLongf* size, const Bytef* from, uLong from_size, int level);
int uncompress(Bytef* to, uLongf* size, const Bytef* from, uLong from_size);
