#pragma once
// A drawing with several pens as a grey picture for each, for printers who make a screen or a plate an ink.
//
// Files of their own rather than pages of one TIFF: what prepares plates and films opens the first page
// alone. Black is where the pen's ink is, all of it, also where a later pen's dots lie over it; grey is the
// share of a pixel that is covered, in proportion, as such programs take it: half is 128 of 255.

#include <filesystem>
#include <ostream>
#include <span>
#include <vector>

#include "app/files/save_drawing.h"

namespace dapple {

/// "cat.tif" of the second pen, "Light grey": "cat-2-light-grey.tif".
std::filesystem::path separation_file(const std::filesystem::path& drawing, std::size_t pen,
                                      const Pen& its_own);

/// Those of all pens.
std::vector<std::filesystem::path> separation_files(const std::filesystem::path& drawing,
                                                    std::span<const Pen> pens);

/// That pen's picture, as a PNG or a TIFF, as large as the drawing's.
void write_separation(std::ostream& out, DrawingFormat format, const DrawingSettings& settings,
                      const DrawingToSave& drawing, int pen, const WritingProgress& progress = {});

}  // namespace dapple
