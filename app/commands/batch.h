#pragma once
// dapple render of many pictures: side by side, with one progress line, and none that goes wrong stops the
// others.

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/render.h"

namespace CLI {
class App;
}

namespace dapple {

// dapple render --sheets: all sheets of a drawing too large for one, and how to join them.

/// --sheets, --overlap. The overlap is of `--sheet` too.
void add_mural_options(CLI::App& app, Sheet& sheets);

/// Says that none of so many pictures or sheets is this run's.
void tell_of_no_share(const WorkShare& share, std::size_t count, const char* things);

/// Draws each of options.drawing.sheets into a file of its own, and the plan beside them. Throws what
/// render() throws; sheets that were drawn before then stay, and the sentence says how many.
void render_mural(const RenderOptions& options);

/// Whether the output is a folder that drawings go into: its name ends in a slash, or it is
/// there and its name has no ending, as that of a drawing has.
bool is_output_folder(const std::filesystem::path& output);

/// Where a picture's drawing goes: into the folder, with the picture's name and the format's ending.
std::filesystem::path output_in(const std::filesystem::path& folder, const std::filesystem::path& picture,
                                DrawingFormat format);

/// Throws std::runtime_error if two pictures' drawings would have the same name.
void check_names_differ(const std::vector<std::filesystem::path>& pictures,
                        const std::filesystem::path& folder, DrawingFormat format);

struct BatchResult {
    struct Failure {
        std::filesystem::path picture;
        std::string why;
    };
    std::size_t drawn = 0;
    std::vector<Failure> failures = {};      // in the order of the pictures
    std::vector<std::string> findings = {};  // see findings_among()
};

/// Draws each picture as `options` say, into the folder options.output, which is made if it is not there. So
/// many are drawn at a time, and no more in memory; 0: one for each two cores, 4 at most. Throws
/// std::runtime_error before anything is drawn if the folder cannot be made.
BatchResult render_batch(const RenderOptions& options, const std::vector<std::filesystem::path>& pictures,
                         int jobs);

/// "12 drawings in out; 2 pictures failed:" and each with its reason, a line each, and what someone should
/// know of the drawings.
std::string batch_summary(const BatchResult& result, const std::filesystem::path& folder);

}  // namespace dapple
