#pragma once
// What `dapple render` does: a picture to a file of dots.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/drawing/page_setup.h"
#include "core/drawing/settings.h"
#include "core/drawing/write_drawing.h"
#include "core/failure.h"
#include "core/output/sheet.h"
#include "io/files/atomic_file.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"

namespace dapple {

/// Of several sheets or pictures those that this one of several runs draws: each `of`-th, from `index` on.
struct WorkShare {
    std::size_t index = 0, of = 1;

    bool has(std::size_t i) const { return i % of == index; }
};

struct RenderOptions {
    std::optional<std::filesystem::path> image;  // none: the built-in sample; "-": the standard input
    std::filesystem::path output;                // ends as drawing_format() has it; "-": the standard output
    std::optional<DrawingFormat> format;         // none: what the output's name says, or SVG
    DrawingSettings drawing;
    SavingChoice saving;
    Sheet sheet;  // the whole drawing, or a part of it; then without saving.region
    PictureLimit limit = PictureLimit::usual;
    WorkShare share;
    std::optional<double> memory;                // bytes that it may take; none: what is available
    std::optional<std::filesystem::path> stats;  // figures about it all, as JSON
    bool advice = false;                         // printed even if no machine was asked for
    std::vector<FileInUse> read = {};            // the picture and all else, which nothing is written over
};

/// What is written: as --format, or else the output's name, says. Throws std::runtime_error if neither does.
DrawingFormat format_of(const RenderOptions& options);

/// Whether the picture comes from there; false where there is none, and the built-in sample is drawn.
bool reads_standard_input(const RenderOptions& options);
/// For messages: "cat.jpg".
std::string name_of_image(const RenderOptions& options);

/// For whoever draws many: called with how far one has come, 0..1, in place of the terminal's line and the
/// report; none: these.
using RenderProgress = std::function<void(double share)>;

struct Rendered;  // app/commands/render_report.h

/// Reads, places and saves one drawing. Throws std::runtime_error with one sentence naming the file that is
/// wrong; what was at the output's place stays then.
Rendered render(const RenderOptions& options, const RenderProgress& progress = {});

/// The same of several parts of one drawing, whose picture is read and planned once: their options differ in
/// sheet and output alone. Each part is told of once it is saved; those saved before something is thrown
/// stay.
void render_parts(std::span<const RenderOptions> parts, const RenderProgress& progress,
                  const std::function<void(const RenderOptions& part, const Rendered& drawn)>& take);

// Where `dapple render` draws: the page, the picture on it, and the part of it that is wanted.

/// What make() makes; an error that it throws gets that option's name before it.
template <class Make>
auto with_option(const char* option, const Make& make) {
    try {
        return make();
    } catch (const std::runtime_error& error) {
        throw failure("{}: {}", option, error.what());
    }
}

/// Whether neither a sheet nor a region was asked for.
bool draws_whole_page(const RenderOptions& options);

/// The layout for a picture of so many pixels, before it is known how large the dots are if that follows from
/// their number. Throws std::runtime_error, "--option: why", for a page that cannot be.
PageLayout layout_for(glm::ivec2 picture, const RenderOptions& options);

/// The page and the part of it that is wanted. Throws as layout_for() does, for a part that does not lie on
/// the page.
DrawnPage page_for(const PageLayout& layout, const RenderOptions& options);

}  // namespace dapple
