#pragma once
// dapple render: a picture to a file of dots.

#include <filesystem>
#include <optional>

#include "app/drawing_settings.h"
#include "app/files/picture.h"
#include "core/output/plotting_time.h"
#include "core/output/sheet.h"
#include "core/placing/dot_order.h"

namespace CLI {
class App;
}

namespace dapple {

struct RenderOptions {
    std::optional<std::filesystem::path> image;  // none: the built-in sample
    std::filesystem::path output;                // .svg, .png or .csv
    DrawingSettings drawing;
    double dpi = 300;                         // of a PNG
    Sheet sheet;                              // the whole drawing, or a part of it
    std::optional<Rectangle<double>> region;  // a part instead of a sheet
    std::optional<DotOrder> order;            // none: usual_order() of the file
    std::optional<Machine> machine;           // whose time is told; none: an AxiDraw's for an SVG
    double margin_mm = 0;                     // of bare paper, on each side within the width
    PictureLimit limit = PictureLimit::usual;
    std::optional<std::filesystem::path> stats;  // figures about it all, as JSON
};

/// Reads, places and saves. Throws std::runtime_error with one sentence naming the file that is wrong; what
/// was at the output's place stays then.
void render(const RenderOptions& options);

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class RenderCommand {
 public:
    explicit RenderCommand(CLI::App& program);
    RenderCommand(const RenderCommand&) = delete;
    RenderCommand& operator=(const RenderCommand&) = delete;

 private:
    RenderOptions options_;
};

}  // namespace dapple
