#pragma once
// The one entry: a picture, a tile and settings become a plan, a drawing and its file.
//
//     Stippler stippler;
//     stippler.set_picture(picture_of_srgb(pixels, width, height, 3));
//     Settings settings;
//     settings.drawing.placing.count = 20'000;
//     settings.drawing.pens = parse_pens("cmyk");
//     const std::optional<Drawing> drawing = stippler.draw(settings);
//     drawing->write(file, DrawingFormat::svg);
//
// The same picture and settings give the same dots to the bit, as the program's, for any number of threads.

#include <cstdint>
#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <optional>
#include <ostream>
#include <string_view>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/drawing/write_drawing.h"
#include "core/export.h"
#include "core/image/density.h"
#include "core/image/grid.h"
#include "core/image/light_picture.h"
#include "core/output/drawing_format.h"
#include "core/output/findings.h"
#include "core/watch.h"

namespace dapple {

/// The format of a text file by the ending of its name, "cat.svg" or "cat.NC", or by its word alone, "gcode".
/// Throws std::runtime_error if it is none of svg, gcode, hpgl, dxf, csv and json.
DAPPLE_API DrawingFormat text_format(std::string_view name);

/// The plan's pens in their order, or one: the ink.
DAPPLE_API Palette pens_of(const DrawingPlan& plan, const DrawingSettings& settings);

/// A page's dots with their plan. It never changes and is cheap to copy; any number of threads may use it.
/// Up to kMostSortedDots are held in memory; of more, each pass over them places them anew, except for those
/// of several pens.
struct Drawing : PlannedDrawing {
    Settings settings;  // that it was drawn with
    DrawnPage page;     // all of it
    std::uint64_t count = 0;

    /// Hands over all dots as they were placed, piece by piece, in millimetres from the page's upper left
    /// corner, each with its radius. A piece is valid during the call; `take` may end all with false. Returns
    /// false if it did.
    DAPPLE_API bool for_each_piece(const TakePiece& take) const;

    /// The copies of the tile that the dots come from, those of all levels, larger ones before their parts,
    /// in millimetres from the page's upper left corner; some lie partly beyond the page.
    DAPPLE_API std::vector<PlacedTile> tiles() const;

    /// The side of the smallest tiles that are all there at the mean density, in millimetres: what the dots
    /// would repeat after, if the tile repeated.
    DAPPLE_API double period_mm() const;

    /// A file's text, with the settings' order, shapes, strokes and pens. False if stopped: what is written
    /// by then is not whole. Throws std::runtime_error if such a file cannot hold the drawing.
    DAPPLE_API bool write(std::ostream& out, DrawingFormat format, const Watch& watch = {}) const;

    /// What to know before such a file is plotted or printed, the most important first. Empty where all is
    /// well, or if stopped. Takes as long as finding the pen's route.
    DAPPLE_API std::vector<Finding> findings(DrawingFormat format, const Watch& watch = {}) const;

    /// So many pixels to the inch, sRGB-encoded, with the settings' ink and paper. Throws std::runtime_error
    /// if `dpi` is not above 0, or if there would be too many.
    DAPPLE_API Grid<glm::u8vec3> pixels(double dpi) const;
};

/// Makes drawings of a picture. Keeps what the next one can use again: a drawing whose settings differ a
/// little takes a fraction of the first one's time. One thread at a time may use it; its drawings do not need
/// it. One that was moved from may be assigned to and destroyed; all else throws std::runtime_error.
class DAPPLE_API Stippler {
 public:
    /// How many threads work, up to 1024; 0: one for each core. They take the place of the settings'. Throws
    /// std::runtime_error if it is another number.
    explicit Stippler(int threads = 0);
    Stippler(Stippler&&) noexcept;
    Stippler& operator=(Stippler&&) noexcept;
    ~Stippler();

    /// Throws std::runtime_error if it has no pixels, other colours than pixels, or a value that is not
    /// finite.
    void set_picture(LightPicture picture);

    /// Instead of a picture the density of the dots itself, 0 to 1, which no tone changes. Throws
    /// std::runtime_error if there is none, or another value.
    void set_density(Grid<float> values, Reading reading = Reading::by_cell);

    /// The text of a tile file, for all drawings from now on, whatever their settings name; empty: the
    /// settings' again. Throws std::runtime_error saying in which line it is wrong.
    void set_tile(std::string_view text);

    /// What is known before a dot is placed. Throws std::runtime_error with one sentence if there is no
    /// picture, or if the settings do not go together with it.
    DrawingPlan plan(const DrawingSettings& settings);

    /// Empty if stopped. Throws as plan() does.
    std::optional<Drawing> draw(const Settings& settings, const Watch& watch = {});

 private:
    struct State;
    State& state();
    std::unique_ptr<State> state_;
};

/// A tile that comes with Dapple, or the paper's two integers, "14217,2895/16". Throws std::runtime_error if
/// it is neither.
DAPPLE_API StoredTile tile_by_name(std::string_view name);

}  // namespace dapple
