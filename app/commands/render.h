#pragma once
// dapple render: a picture to a file of dots.

#include <filesystem>
#include <optional>

#include "app/drawing_settings.h"
#include "app/files/drawing_format.h"
#include "app/files/picture.h"
#include "core/output/gcode.h"
#include "core/output/plotting_time.h"
#include "core/output/sheet.h"
#include "core/placing/dot_order.h"

namespace CLI {
class App;
}

namespace dapple {

struct RenderOptions {
    std::optional<std::filesystem::path> image;          // none: the built-in sample; "-": the standard input
    std::optional<std::filesystem::path> project;        // that it was named by
    std::optional<std::filesystem::path> settings_from;  // whose settings it is drawn with
    std::filesystem::path output;         // ends as drawing_format() has it; "-": the standard output
    std::optional<DrawingFormat> format;  // none: what the output's name says, or SVG
    DrawingSettings drawing;
    SavingChoice saving;
    Sheet sheet;                                  // the whole drawing, or a part of it
    std::optional<Rectangle<double>> region;      // a part instead of a sheet
    GcodeStyle gcode;                             // but for its lines, which the machine or the template says
    std::optional<GcodeTemplate> gcode_template;  // instead of the saving choice's machine
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
    bool automatic_tone_ = true;  // before the options say another
};

}  // namespace dapple
