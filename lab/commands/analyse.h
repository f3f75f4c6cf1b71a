#pragma once
// dapple-lab analyse: how even a set of points is, and whether it repeats.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/analysis/domain.h"
#include "core/drawing/settings.h"
#include "io/files/picture.h"

namespace CLI {
class App;
}

namespace dapple {

struct AnalyseOptions {
    std::optional<std::filesystem::path> input;  // a table (.csv, .tsv, .txt), a drawing of ours (.json,
                                                 // .svg) or a picture; none: a constant grey
    std::filesystem::path output;                // .json, .html or .png
    DrawingSettings drawing;                     // of a picture or a grey
    double grey = 1;                             // its density
    std::optional<std::string> method{};  // of a grey: whose dots, of related_methods(); none: this program's
    std::uint64_t seed = 1;               // of the method
    std::optional<Topology> topology;     // none: window, but torus for a grey
    std::optional<double> width, height;  // of a table's domain; the width in mm of a picture's page
    std::optional<double> period;         // of a table, in its unit
    PictureLimit limit = PictureLimit::usual;
    std::optional<double> memory;  // bytes that it may take; none: what is available
};

/// Reads, analyses and saves. Throws std::runtime_error with one sentence; what was at the output's place
/// stays then.
void analyse(const AnalyseOptions& options);

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class AnalyseCommand {
 public:
    explicit AnalyseCommand(CLI::App& program);
    AnalyseCommand(const AnalyseCommand&) = delete;
    AnalyseCommand& operator=(const AnalyseCommand&) = delete;

 private:
    AnalyseOptions options_;
};

}  // namespace dapple
