#pragma once
// A drawing into a file, for the window and the command line alike.

#include <filesystem>
#include <ostream>
#include <string>

#include "core/drawing/drawing.h"
#include "core/drawing/write_drawing.h"
#include "core/output/drawing_format.h"
#include "core/output/ink.h"
#include "core/watch.h"

namespace dapple {

// The kind of file that a name asks for.

/// What a name's ending says, in upper or lower case. Throws std::runtime_error if it is another.
DrawingFormat drawing_format(const std::filesystem::path& path);

/// What stands for the standard input and the standard output in place of a file's name.
inline constexpr const char* kStandardStream = "-";
inline bool is_standard_stream(const std::filesystem::path& path) {
    return path == kStandardStream;
}

/// Into the stream, the dots in the order they come in. A PDF has that title. A TIFF is written by going back
/// in the stream. Throws if the format cannot hold such a drawing.
void write_drawing(std::ostream& out, const DrawingToSave& drawing, const std::string& title,
                   const WritingProgress& progress = {});

/// Writes a drawing whose dots come in the order of the file, and files for each pen if they are asked for:
/// see files_of() in separations.h. To the standard output if the name is kStandardStream, which takes no
/// TIFF, and has all in one. Returns false if stopped. Throws what save_atomically() throws, or if the format
/// cannot hold such a drawing. In both cases an existing file stays as it was.
bool save_ordered(const DrawingToSave& drawing, const Watch& watch = {});

/// The same of dots in any order: they are put in order_of() first.
bool save_drawing(const DrawingToSave& drawing, const Watch& watch = {});

// A page into its file, or its sheets into theirs.

/// Writes the page or the region of it that is chosen, or its sheets and their plan: see files_of() in
/// sheet_files.h. False if stopped: sheets that were written before then stay. Throws what save_drawing()
/// throws, or if the sheets' overlap is too wide or the region does not lie on the page.
bool save_page(const PlannedDrawing& drawing, const DrawingFile& file, const Watch& watch);

}  // namespace dapple
