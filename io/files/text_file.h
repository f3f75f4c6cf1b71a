#pragma once
// A whole file of text as it is.

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/drawing/settings.h"
#include "io/files/picture.h"

namespace dapple {

// A person's own template for G-code, out of a file.

/// Throws std::runtime_error naming the file, and the line that is wrong.
OwnTemplate read_gcode_template(const std::filesystem::path& file);

// The standard input as a picture.

/// Copies it to a temporary file, since decoders are programs of their own and go back and forth in what they
/// read, and reads that as read_picture() does. The file is gone afterwards, also if a signal ends the
/// program. Throws std::runtime_error with one sentence that begins with "the standard input".
Picture read_picture_from_standard_input(PictureLimit limit = PictureLimit::usual,
                                         PictureColours colours = PictureColours::left_out);

// What the end of a file's name says, however it is written.

/// ASCII letters only; others stay.
std::string lower_case(std::string text);

/// ".svg" of "CAT.SVG"; empty if there is none.
std::string ending_of(const std::filesystem::path& file);

/// What is expected of a file.
struct TextKind {
    const char* what = "table";  // "a tile": in "..., as no tile is"
    std::uintmax_t most_bytes = 2'000'000'000;
    /// Pipes and devices too, which may have one wait for whoever writes into them: where a person names what
    /// is to be read, as by a shell's <(...). Else nothing is waited for.
    bool may_wait = false;
    /// Only so many bytes are wanted, whatever they are, of a file of any size.
    bool beginning = false;
    bool binary = false;  // bytes of value 0 too
};

/// Throws std::runtime_error with one sentence if the file is missing, a folder, larger, no text, or cannot
/// be read.
std::string text_of_file(const std::filesystem::path& file, const TextKind& kind);

}  // namespace dapple
