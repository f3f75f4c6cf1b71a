#pragma once
// How large a file would be, told before it is written.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "app/files/save_drawing.h"
#include "app/viewer/model/pane.h"

namespace dapple {

/// What would be written, as save_drawing() gets it; dots in memory.
struct EstimatedDrawing {
    const DotPieces& dots;
    double scale = 0;
    PageSize page;
    double dot_radius_mm = 0;
    std::span<const PlacedTile> tiles = {};
    std::size_t tile_size = 16;
    double dpi = 300;
    GcodeTool tool = GcodeTool::pen;
};

/// Bytes, about: the format's own writer writes some of the dots, or some of the pixels, and the rest is
/// taken to be like them. Throws std::runtime_error as the writer would.
double estimated_bytes(DrawingFormat format, const DrawingSettings& settings,
                       const EstimatedDrawing& drawing);

/// What saving would write.
struct ExportInfo {
    std::uint64_t dots = 0;
    std::optional<double> bytes;  // about; none if it cannot be written
    std::string trouble;          // why not
    double area_mm2 = 0;          // of the page
};

/// Estimates anew only when something changed.
class ExportEstimate {
 public:
    ExportInfo info(const Pane& pane, const ViewerSettings& settings, DrawingFormat format);

 private:
    struct Key {
        std::uint64_t placings = 0;
        DrawingFormat format{};
        DrawingSettings drawing;
        double dpi = 0;
        GcodeTool tool{};
        bool operator==(const Key&) const = default;
    };
    std::optional<Key> key_;
    ExportInfo facts_;
};

}  // namespace dapple
