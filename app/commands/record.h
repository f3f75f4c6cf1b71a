#pragma once
// dapple record: a film of how a drawing comes about.

#include <filesystem>
#include <optional>

#include "core/drawing/settings.h"
#include "io/files/picture.h"
#include "io/film/film.h"
#include "io/settings/embedded_settings.h"

namespace CLI {
class App;
}

namespace dapple {

struct RecordOptions {
    std::optional<std::filesystem::path> image;  // none: the built-in sample
    std::filesystem::path output;                // see check_film_path()
    DrawingSettings drawing;
    FilmChoice film;
};

/// Throws std::runtime_error with one sentence naming the file that is wrong; what was at the output's place
/// stays then.
void record(const RecordOptions& options);

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class RecordCommand {
 public:
    explicit RecordCommand(CLI::App& program);
    RecordCommand(const RecordCommand&) = delete;
    RecordCommand& operator=(const RecordCommand&) = delete;

 private:
    void take(const SavedSettings& settings);

    RecordOptions options_;
    std::optional<Rectangle<double>> region_;  // of the settings, which are for drawings
    PictureLimit limit_ = PictureLimit::usual;
    bool automatic_tone_ = true;  // before the options say another
};

}  // namespace dapple
