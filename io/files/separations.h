#pragma once
// A drawing with several pens in files for each of them: as a drawing of that pen's dots alone, in place of
// one for all; or as a grey picture beside the drawing, for printers who make a screen or a plate an ink.
//
// Pictures are files of their own rather than pages of one TIFF: what prepares plates and films opens the
// first page alone. Black is where the pen's ink is, all of it, also where a later pen's dots lie over it;
// grey is the share of a pixel that is covered, in proportion, as such programs take it: half is 128 of 255.

#include <filesystem>
#include <ostream>
#include <span>
#include <vector>

#include "io/files/save_drawing.h"

namespace dapple {

/// "cat.tif" of the second pen, "Light grey": "cat-2-light-grey.tif".
std::filesystem::path file_of_pen(const std::filesystem::path& drawing, std::size_t pen, const Pen& its_own);

/// Whether each pen has a file instead of one for all: SVG, PDF, G-code, HPGL and DXF can be taken apart so.
bool has_pen_files(DrawingFormat format, const SavingChoice& saving, std::span<const Pen> pens);

/// Whether there are grey pictures beside the drawing, which is a PNG or a TIFF.
bool has_separations(DrawingFormat format, const SavingChoice& saving, std::span<const Pen> pens);

/// All that save_drawing() writes under that name: the drawing and what there is for each pen.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& drawing, DrawingFormat format,
                                            const SavingChoice& saving, std::span<const Pen> pens);

/// What that pen alone draws, as a drawing with one pen.
DrawingToSave drawing_of_pen(const DrawingToSave& drawing, std::size_t pen);

/// That pen's picture, as a PNG or a TIFF, as large as the drawing's; with registration_marks() if the
/// settings ask for them.
void write_separation(std::ostream& out, const DrawingToSave& drawing, std::size_t pen,
                      const WritingProgress& progress = {});

}  // namespace dapple
