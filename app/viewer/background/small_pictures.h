#pragma once
// Small pictures for the entries of lists, made in the background one at a time: each entry on screen asks
// for its own in every frame, and has it once it is made. What is not on screen is never made.

#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "app/viewer/background/background.h"
#include "core/drawing/settings.h"
#include "core/image/grid.h"

namespace dapple {

// A picture in ever smaller copies, so that a drawing of it from afar looks at few of its pixels.
//
// Made here, beside the window's thread, and not by OpenGL, which makes all of them in one frame.

/// The picture itself, then copies of half the sides, rounded down, to one of a single pixel. Each pixel is
/// the mean of four. None of an empty picture.
std::vector<Grid<glm::u8vec4>> mipmaps_of(Grid<glm::u8vec4> picture);

/// The largest of them whose longer side is at most so long; empty if there is none.
Grid<glm::u8vec4> small_copy(const std::vector<Grid<glm::u8vec4>>& mipmaps, int longest_side);

/// sRGB-encoded, opaque. Empty: there is none.
using SmallPicture = Grid<glm::u8vec4>;

class SmallPictures {
 public:
    using Make = std::function<SmallPicture(const std::stop_token&)>;

    /// `wake` is called from another thread whenever one is made.
    explicit SmallPictures(std::function<void()> wake) : making_(std::move(wake)) {}

    /// The picture of that key; null while it is still to be made, which begins once no other is under way.
    /// One that cannot be made (`make` throws) is empty. Valid until forget().
    const SmallPicture* of(const std::string& key, const Make& make);

    /// Gives up what is being made, and all memory.
    void forget();

 private:
    struct Made {
        std::string key;
        SmallPicture picture;
    };
    void take_made();

    std::map<std::string, SmallPicture> made_;
    std::string under_way_;  // the key of what was begun last
    Background<Made> making_;
};

// What settings make of a picture, small: the preview of a preset.

/// The whole page, its longer side so many pixels. The picture is sRGB-encoded, as the window shows it, and
/// may be a small copy. Dots are relaxed once at most, which nobody can tell at such a size. Empty if
/// stopped. Throws as Workbench::place().
SmallPicture small_drawing(const SmallPicture& picture, DrawingSettings settings, int longer_side,
                           const std::stop_token& stop);

}  // namespace dapple
