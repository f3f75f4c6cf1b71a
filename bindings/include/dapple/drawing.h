#pragma once
// From a picture to its dots, and from these to files:
//
//     Stippler stippler;
//     stippler.set_picture(picture_of_srgb(pixels, width, height, 3));
//     const std::optional<Drawing> drawing = stippler.draw(Settings());
//     drawing->write(file, FileFormat::svg);
//
// The same picture and settings give the same dots to the bit, as the program's, for any number of threads.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "dapple/export.h"
#include "dapple/picture.h"
#include "dapple/settings.h"

namespace dapple {

/// For someone who waits. Both may be left empty.
struct Watch {
    std::stop_token stop = {};                        // asks to give up
    std::function<void(double share)> progress = {};  // told now and then how much is done, 0..1
};

/// Dots that lie side by side in memory, in millimetres from the page's upper left corner.
struct DotSpan {
    std::span<const float> x, y, radius;
    int pen = 0;  // whose they are: its place in Drawing::pens()
};

/// The square of a copy of the tile, in millimetres from the page's upper left corner.
struct DrawnTile {
    int level = 0;                  // its side is 2^-level of the picture's longer side
    double x = 0, y = 0, side = 0;  // its upper left corner may lie beyond the page
    std::size_t kind = 0;           // which of the tile's kinds it is
};

struct DrawingPen {
    std::string name;
    float red = 0, green = 0, blue = 0;  // sRGB-encoded, 0..1
};

struct PagePixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  // sRGB-encoded, row after row from the top
};

/// What settings come to on a picture, before a dot is placed.
struct Plan {
    std::uint64_t dots = 0;                        // exactly, or about so many where none are asked for
    bool lowered = false;                          // more were asked for than there may be
    int steps = 0;                                 // in which they settle
    double page_width_mm = 0, page_height_mm = 0;  // margins and all
    double radius_mm = 0;                          // of all dots, or of the largest
    std::vector<DrawingPen> pens = {};             // one: the ink
    // The tone as drawn, with what was chosen automatically, in the units of the settings.
    double exposure = 0, black_point = 0, white_point = 1, contrast = 0, brightness = 0, gamma = 1, black = 1;
};

/// What someone who is about to plot or print a drawing should know of it.
struct Advice {
    std::string kind;   // "overlap"
    std::string text;   // "40 % of the dots run into others; fewer dots part them"
    double amount = 0;  // that it speaks of: dots, millimetres or dots per inch; 0: none
};

/// What a density's value holds for.
enum class Interpolation {
    nearest,  // all of its cell, exactly: no dot lies where it is 0
    linear,   // the middle of its cell; between four middles it changes evenly, as a picture's does
};

enum class FileFormat { svg, gcode, hpgl, dxf, csv, json };

/// By the ending of a file's name, "cat.svg" or "cat.NC", or by its word alone, "gcode". Throws
/// std::runtime_error if it is none of these.
DAPPLE_API FileFormat file_format(std::string_view name);

/// Never changes, and is cheap to copy; moving it copies it. Up to five million dots are held in memory; of
/// more, each pass over them places them anew, except for those of several pens.
class DAPPLE_API Drawing {
 public:
    Drawing(const Drawing&) = default;
    Drawing& operator=(const Drawing&) = default;

    std::uint64_t count() const;
    double page_width_mm() const;
    double page_height_mm() const;
    std::vector<DrawingPen> pens() const;  // one: the ink

    /// Hands over all dots, as they were placed. `take` may end it with false. Returns false if it did.
    bool for_each(const std::function<bool(const DotSpan&)>& take) const;

    /// The copies of the tile that the dots come from, those of all levels, larger ones before their parts.
    std::vector<DrawnTile> tiles() const;

    /// The side of the smallest tiles that are all there at the mean density, in millimetres: what the dots
    /// would repeat after, if the tile repeated.
    double period_mm() const;

    /// As a file of that kind, with the settings' order, shapes, strokes and pens. False if stopped: what is
    /// written by then is not whole. Throws std::runtime_error if such a file cannot hold the drawing.
    bool write(std::ostream& out, FileFormat format, const Watch& watch = {}) const;

    /// What to know before such a file is plotted or printed, the most important first; nothing where all is
    /// well, or if stopped. Takes as long as finding the pen's way.
    std::vector<Advice> advice(FileFormat format, const Watch& watch = {}) const;

    /// As pixels, so many to the inch, with the settings' ink and paper. Throws std::runtime_error if that is
    /// not above 0, or if there would be too many.
    PagePixels pixels(double dpi) const;

    struct State;

 private:
    friend class Stippler;
    explicit Drawing(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

/// Makes drawings of a picture. Keeps what the next one can use again, so that a drawing whose settings
/// differ a little takes a fraction of the first one's time. One thread at a time may use it; drawings that
/// it made do not need it. One that was moved from may be assigned to and destroyed; all else throws
/// std::runtime_error.
class DAPPLE_API Stippler {
 public:
    /// How many threads work, up to 1024; 0: one for each core. Throws std::runtime_error if it is another
    /// number.
    explicit Stippler(int threads = 0);
    Stippler(Stippler&&) noexcept;
    Stippler& operator=(Stippler&&) noexcept;
    ~Stippler();

    /// Throws std::runtime_error if its sides and its values do not agree.
    void set_picture(const LightPicture& picture);

    /// Instead of a picture the density of the dots itself, which no tone changes: width * height values of 0
    /// to 1, row after row from the top. Throws std::runtime_error if they are not.
    void set_density(std::span<const float> values, int width, int height,
                     Interpolation interpolation = Interpolation::nearest);

    /// The text of a tile file, for all drawings from now on, whatever their settings name; empty: these
    /// again. Throws std::runtime_error saying in which line it is wrong.
    void set_tile(std::string_view text);

    /// Throws std::runtime_error with one sentence if there is no picture, or if the settings do not go
    /// together with it.
    Plan plan(const Settings& settings);

    /// Nothing if stopped. Throws as plan() does.
    std::optional<Drawing> draw(const Settings& settings, const Watch& watch = {});

 private:
    struct State;
    State& state();
    std::unique_ptr<State> state_;
};

}  // namespace dapple
