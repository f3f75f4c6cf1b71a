// dapple mask: a threshold mask for screening, as pictures.

#include "app/commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/drawing/settings.h"
#include "core/maths/portable_math.h"
#include "core/screening/threshold_mask.h"
#include "core/text/number_words.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/picture.h"
#include "io/files/png_file.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "io/progress_line.h"

namespace dapple {

/// What orders a mask's pixels.
enum class MaskOrder { clusters, tile };
constexpr auto names_of(MaskOrder) {
    return names("clusters", "tile");
}

namespace {

struct MaskOptions {
    ThresholdSize size;
    MaskOrder order = MaskOrder::clusters;
    VoidAndClusterOptions clusters;
    std::string tile = kDefaultTile;
    int bits = 8;
    double gain = 0;
    std::filesystem::path output;
    std::optional<std::filesystem::path> screens;  // a picture
};

// "256", "320x200" or "64x64x16".
ThresholdSize size_in(const std::string& text) {
    ThresholdSize size;
    if (const auto side = number_of<int>(text))
        size = {*side, *side, 1};
    else if (const auto sides = numbers_of<int, 2>(text, "x"))
        size = {(*sides)[0], (*sides)[1], 1};
    else if (const auto all = numbers_of<int, 3>(text, "xx"))
        size = {(*all)[0], (*all)[1], (*all)[2]};
    else
        throw std::runtime_error(text + " is not a size; give one such as 256, 320x200 or 64x64x16");
    check_threshold_size(size);
    return size;
}

template <class Channel>
void save_grey(const std::filesystem::path& file, const Grid<float>& thresholds) {
    const double levels = std::exp2(8 * sizeof(Channel));
    Grid<glm::vec<3, Channel>> greys(thresholds.width, thresholds.height);
    for (std::size_t i = 0; i < thresholds.values.size(); ++i)
        greys.values[i] = glm::vec<3, Channel>(
            static_cast<Channel>(std::min(std::floor(thresholds.values[i] * levels), levels - 1)));
    const PngHeader header{
        .width = thresholds.width, .height = thresholds.height, .dpi = 96, .colours = PngColours::grey};
    save_atomically(file, [&](std::ostream& out) {
        write_png<Channel>(out, header, [&](const SinkOf<Channel>& sink) { sink(greys); });
    });
}

// mask-03.png for mask.png.
std::filesystem::path beside(const std::filesystem::path& file, const std::string& what) {
    std::filesystem::path other = file;
    return other.replace_filename(file.stem().string() + "-" + what + ".png");
}

// Numbers with as many digits as the last has.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& output, int slices) {
    if (slices == 1) return {output};
    const std::size_t digits = std::to_string(slices - 1).size();
    std::vector<std::filesystem::path> files;
    for (int slice = 0; slice < slices; ++slice)
        files.push_back(beside(output, fmt::format("{:0{}}", slice, digits)));
    return files;
}

Grid<float> light_of(const std::filesystem::path& picture) {
    Picture read = read_with_remark(picture);
    for (float& value : read.light.values) value *= portable::exp2(read.exposure);
    return std::move(read.light);
}

void check(const CLI::App& command, const MaskOptions& options) {
    if (ending_of(options.output) != ".png")
        throw CLI::ValidationError("--output",
                                   options.output.string() + ": a mask is a PNG; let its name end in .png");
    if (options.order == MaskOrder::tile) {
        refuse(command, {"--sigma", "--slice-sigma", "--seed"},
               "applies to --from clusters only; leave it out");
        if (options.size.slices > 1 || options.size.width != options.size.height)
            throw CLI::ValidationError("--size", "a mask from a tile is square; give one side, as in 256");
    } else {
        refuse(command, {"--tile"}, "applies to --from tile only; give that too");
        if (options.size.slices == 1)
            refuse(command, {"--slice-sigma"},
                   "applies to several slices only; give a size such as 64x64x16");
    }
    std::vector<FileInUse> written;
    for (const std::filesystem::path& file : files_of(options.output, options.size.slices))
        written.push_back({file, "the mask"});
    if (options.screens) written.push_back({beside(options.output, "screened"), "the screened picture"});
    check_apart(command, {"--output"}, written);
}

void save(const MaskOptions& options) {
    const std::vector<std::filesystem::path> files = files_of(options.output, options.size.slices);
    check_can_save(files.front());
    const Grid<float> picture = options.screens ? light_of(*options.screens) : Grid<float>();
    ThresholdMask mask;
    if (options.order == MaskOrder::tile) {
        RankedTile tile = tile_named(options.tile);
        mask = tile_mask(tile, options.size.width);
    } else {
        ProgressLine line;
        mask = void_and_cluster(options.size, options.clusters, [&](double share) {
            line.show(share, "finding the voids");
            return true;
        });
    }
    for (std::size_t slice = 0; slice < files.size(); ++slice) {
        const Grid<float> thresholds = thresholds_of(mask, static_cast<int>(slice), options.gain);
        const auto save_mask = options.bits == 16 ? save_grey<std::uint16_t> : save_grey<std::uint8_t>;
        save_next(slice, [&] { save_mask(files[slice], thresholds); });
        if (options.screens && slice == 0)
            save_grey<std::uint8_t>(beside(options.output, "screened"), screened(picture, thresholds));
    }
}

}  // namespace

Command add_mask_command(CLI::App& program) {
    const auto kept = std::make_shared<MaskOptions>();
    MaskOptions& options = *kept;
    CLI::App* const command = program.add_subcommand(
        "mask",
        "Make a tileable threshold mask (blue noise), which turns pictures into dots on a pixel grid");
    add_text(
        *command, "--size", "WxH", [&options](const std::string& text) { options.size = size_in(text); },
        "Size in pixels: 256, or 320x200; 64x64x16 for the 16 pictures of a film, even in each and over time")
        ->default_str("64");
    add_choice(*command, "--from", options.order,
               "clusters: void and cluster, the most even; tile: the order of a self-similar tile's dots");
    add_number(*command, "--sigma", options.clusters.sigma, {.least = 0.5, .most = 4}, "PIXELS",
               "clusters: how far a pixel affects others")
        ->default_str("1.5");
    add_number(*command, "--slice-sigma", options.clusters.slice_sigma, {.least = 0.5, .most = 8}, "SLICES",
               "clusters of several slices: how far a pixel affects itself before and after")
        ->default_str("1.5");
    add_seed(*command, options.clusters.seed, "clusters: another seed gives another mask");
    add_tile(*command, options.tile);
    add_text(
        *command, "--bits", "8|16",
        [&options](const std::string& text) {
            if (text != "8" && text != "16")
                throw std::runtime_error(text + " is not possible; give 8 or 16");
            options.bits = text == "8" ? 8 : 16;
        },
        "Bits per threshold: 8 have 256 steps; 16 give every pixel of a mask up to 256 x 256 its own")
        ->default_str("8");
    add_number(*command, "--gain", options.gain, {.least = 0, .most = 4}, "PIXELS",
               "How far a printed pixel spreads beyond its edges; greys then print as dark as they should")
        ->default_str("0");
    command
        ->add_option(
            "-o,--output", options.output,
            "The mask; its name ends in .png. Several slices become mask-00.png, mask-01.png and so on")
        ->type_name("FILE")
        ->required();
    command
        ->add_option("--screen", options.screens,
                     "Also turns this picture into dots with the mask: mask-screened.png beside mask.png")
        ->type_name("IMAGE");
    command->footer(
        "A pixel is inked where the picture's darkness, 1 - light (linear), is above (mask + 1/2) / 256, or "
        "/ 65536.\n\n"
        "Examples:\n"
        "  dapple mask --size 256 -o mask.png                  void and cluster\n"
        "  dapple mask --size 128 --bits 16 --gain 0.3 -o mask.png --screen cat.jpg\n"
        "  dapple mask --size 64x64x16 -o film.png             film-00.png to film-15.png\n"
        "  dapple mask --size 256 --from tile -o mask.png      the order of the built-in tile");
    command->callback([&options, command] {
        check(*command, options);
        save(options);
    });
    return kept;
}

}  // namespace dapple
