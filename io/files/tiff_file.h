#pragma once
// TIFF into a stream, with the size on paper in it, for print.

#include <ostream>

#include "io/files/png_file.h"

namespace dapple {

/// As write_png(): compressed by LZW without loss, the resolution in pixels to the inch;
/// BigTIFF where four gigabytes might not do. The stream has to be one that can go back, and nothing may be
/// in it yet: a TIFF says at its beginning where its end is. Throws std::runtime_error if the stream cannot
/// go back, as pipes; what `draw` or the stream throw passes through.
template <class Channel>
void write_tiff(std::ostream& out, const PngHeader& header, const DrawInto<Channel>& draw);

}  // namespace dapple
