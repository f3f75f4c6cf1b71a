// dapple-lab volume: even dots in space, of a density or of a point cloud.

#include "lab/commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/text_file.h"
#include "io/film/film.h"
#include "io/progress_line.h"
#include "lab/volume/resample_cloud.h"
#include "lab/volume/settle_volume.h"
#include "lab/volume/turning_view.h"
#include "lab/volume/volume.h"
#include "lab/volume/volume_file.h"

namespace dapple {

class VolumeCommand {
 public:
    explicit VolumeCommand(CLI::App& program);

 private:
    void run(const CLI::App& command) const;

    std::vector<std::filesystem::path> inputs_;
    std::uint64_t dots_ = 10'000;
    int relax_ = 20;
    bool invert_ = false;
    std::filesystem::path output_;
    std::optional<std::filesystem::path> film_;
};

namespace {

constexpr std::uint64_t kMostVolumeDots = 20'000'000;
constexpr FilmChoice kTurn{.seconds = 5, .frames_per_second = 15, .longer_side = 400};

bool is_cloud(const std::filesystem::path& input) {
    return ending_of(input) == ".ply";
}

// And not a slice of one.
bool is_whole(const std::filesystem::path& input) {
    return is_cloud(input) || ending_of(input) == ".nrrd" || input == "cube" || input == "ball" ||
           input == "gyroid";
}

Volume volume_from(const std::vector<std::filesystem::path>& inputs) {
    const std::filesystem::path& input = inputs.front();
    if (input == "cube") return cube_volume();
    if (input == "ball") return ball_volume();
    if (input == "gyroid") return gyroid_volume();
    return ending_of(input) == ".nrrd" ? read_nrrd(input) : read_slices(inputs, &print_remark);
}

void turn_over(Volume& volume) {
    const float most = std::ranges::max(volume.density);
    for (float& density : volume.density) density = most - density;
    told_as("--invert", [&] { check_volume(volume); });
}

std::vector<glm::dvec3> placed(Volume volume, std::uint64_t count, int steps) {
    std::vector<glm::dvec3> dots = place_in_volume(volume_tile(), volume, count);
    ProgressLine line;
    settle(dots, volume, steps, [&](int step) {
        line.show(static_cast<double>(step) / steps, "settling");
        return true;
    });
    // Floats tell dots apart, but for such that lie far from where they are counted from.
    for (glm::dvec3& dot : dots)
        dot = volume.corner == glm::dvec3(0) ? glm::dvec3(glm::vec3(dot * volume.spacing))
                                             : volume.corner + dot * volume.spacing;
    return dots;
}

std::vector<glm::dvec3> thinned(const std::filesystem::path& file, std::uint64_t count) {
    const std::vector<glm::dvec3> cloud = read_ply(file);
    std::vector<glm::dvec3> points;
    told_as("--dots", [&] {
        for (const std::size_t point : even_subset(cloud, count)) points.push_back(cloud[point]);
    });
    return points;
}

}  // namespace

VolumeCommand::VolumeCommand(CLI::App& program) {
    CLI::App* const command = program.add_subcommand(
        "volume", "Place even dots in space, by a density or by thinning a point cloud");
    command
        ->add_option(
            "density", inputs_,
            "A block of voxels (.nrrd, raw), or pictures of its slices, where light is dense; cube, ball "
            "or gyroid, which are built in; or a point cloud (.ply)")
        ->type_name("DENSITY")
        ->required();
    command->add_option("-o,--output", output_, "The points: a name that ends in .ply or .csv")
        ->type_name("OUT")
        ->required();
    add_count(*command, "-n,--dots", dots_, kMostVolumeDots,
              "Exactly this many: 10000, 10,000 or 10k. Of a point cloud, this many of its own points")
        ->default_str("10000");
    add_whole_number(*command, "--relax", relax_, {.least = 0, .most = 100},
                     "Moves the dots in this many steps until they are even");
    command->add_flag("--invert", invert_, "Dark is dense");
    command
        ->add_option(
            "--film", film_,
            "Also films them turning round once: a name ending in .webp, or a folder for numbered PNG files")
        ->type_name("FILM");
    command->footer(
        "Dots of a density lie in voxels times the file's spacings, the first voxel from 0 to 1, or where "
        "its "
        "space\norigin says; x is to the right, y down a slice, z from slice to slice.\n\n"
        "Examples:\n"
        "  dapple-lab volume gyroid -o gyroid.ply -n 20000 --film gyroid.webp\n"
        "  dapple-lab volume slices/*.png -o cells.csv -n 50k\n"
        "  dapple-lab volume scan.ply -o even.ply -n 5000              5,000 even points of a scan's");
    command->callback([this, command] { run(*command); });
}

void VolumeCommand::run(const CLI::App& command) const {
    const std::string ending = ending_of(output_);
    if (ending != ".ply" && ending != ".csv")
        throw CLI::ValidationError("--output", output_.string() + ": let the name end in .ply or .csv");
    const bool cloud = is_cloud(inputs_.front());
    if (inputs_.size() > 1 && std::ranges::any_of(inputs_, is_whole))
        throw CLI::ValidationError("density",
                                   "several files are the slices of one volume; give pictures alone");
    if (cloud)
        refuse(command, {"--relax", "--invert"},
               "applies to a density; a point cloud's points stay where they are");
    std::vector<FileInUse> written{{output_, "the points"}}, read;
    if (film_) check_film_path(*film_);
    if (film_)
        for (const std::filesystem::path& file : files_of(*film_, kTurn))
            written.push_back({file, "the film"});
    check_apart(command, {"--output", "--film"}, written, read);
    check_can_save(output_);

    std::vector<glm::dvec3> points;
    if (cloud) {
        points = thinned(inputs_.front(), dots_);
    } else {
        Volume volume = volume_from(inputs_);
        if (invert_) turn_over(volume);
        points = placed(std::move(volume), dots_, relax_);
    }
    save_atomically(output_, [&](std::ostream& out) {
        ending == ".ply" ? write_ply(out, points) : write_points_csv(out, points);
    });
    if (!film_) return;
    ProgressLine line;
    save_film(*film_, [&](double share) { return turned_view(points, share, kTurn.longer_side); }, kTurn,
              {.stop = {}, .progress = [&](double share) { line.show(share, "drawing the film"); }});
}

Command add_volume_command(CLI::App& program) {
    return std::make_shared<VolumeCommand>(program);
}

}  // namespace dapple
