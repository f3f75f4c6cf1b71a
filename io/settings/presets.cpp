#include "io/settings/presets.h"

#include <algorithm>

#include "core/failure.h"
#include "core/settings/drawing_fields.h"
#include "core/settings/fields.h"
#include "core/text/shown_text.h"
#include "io/files/text_file.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

PageSetup upright_page(Paper paper, double margin_mm) {
    PageSetup page;
    page.paper = paper;
    page.margins = Margins{margin_mm, margin_mm, margin_mm, margin_mm};
    return page;
}

DrawingSettings drawing_of(std::uint64_t dots, const PageSetup& page) {
    DrawingSettings drawing;
    drawing.placing.count = dots;
    drawing.page = page;
    return drawing;
}

DrawingSettings light_on(const char* paper, DrawingSettings drawing) {
    drawing.tone.invert = true;
    drawing.ink = kWhite;
    drawing.paper = parse_colour(paper);
    drawing.background = true;
    return drawing;
}

DrawingSettings coloured(const char* ink, const char* paper, DrawingSettings drawing) {
    drawing.ink = parse_colour(ink);
    drawing.paper = parse_colour(paper);
    drawing.background = true;
    return drawing;
}

DrawingSettings sized_by_tone(double smallest_mm, double largest_mm, DrawingSettings drawing) {
    drawing.dot_size = {.sizing = DotSizing::by_tone, .smallest_mm = smallest_mm, .largest_mm = largest_mm};
    return drawing;
}

DrawingSettings inked(double contours, double solid, DrawingSettings drawing) {
    drawing.contours = contours;
    drawing.solid = solid;
    return drawing;
}

std::vector<Preset> made_presets() {
    const PageSetup a4 = upright_page(Paper::a4, 15), a2 = upright_page(Paper::a2, 30);
    const SavingChoice for_pen{.order = DotOrder::shortest};
    return {
        {"fine-pen", "many small dots on A4, by a short route for a pen", {drawing_of(60'000, a4), for_pen}},
        {"quick-pen", "few dots on A4, plotted in a few minutes", {drawing_of(5'000, a4), for_pen}},
        {"bold-print",
         "few large dots on A4, for prints seen from afar",
         {drawing_of(12'000, a4), {.dpi = 600}}},
        {"light-sketch",
         "sepia dots on cream paper",
         {coloured("#5b3a1e", "#f7f0e0", drawing_of(15'000, a4)), {}}},
        {"night", "white dots on black", {light_on("#000000", drawing_of(40'000, {})), {}}},
        {"blueprint", "white dots on blue", {light_on("#1d4e89", drawing_of(40'000, a4)), {}}},
        {"dots-by-tone",
         "small dots in light parts, large ones in dark, on A4",
         {sized_by_tone(0.2, 0.6, drawing_of(kDefaultDots, a4)), {}}},
        {"portrait",
         "contours, solid blacks and few dots on A4",
         {inked(0.6, 0.8, drawing_of(8'000, a4)), {}}},
        {"engraving",
         "many contours, solid blacks and fine dots on A4",
         {inked(0.8, 0.85, drawing_of(40'000, a4)), {}}},
        {"field-guide",
         "contours and fine dots on A4, nothing solid",
         {inked(0.5, 1, drawing_of(20'000, a4)), {}}},
        {"poster", "very many dots on A2", {drawing_of(400'000, a2), {.dpi = 600}}},
    };
}

NamedFiles preset_files(const fs::path& folder) {
    NamedFiles files{.folder = folder, .what = "preset", .ending = kProjectEnding};
    for (const Preset& preset : built_in_presets()) files.built_in.push_back(preset.name);
    return files;
}

Describe all_of_preset(SavedSettings& settings) {
    return [&](Fields& fields) { describe_drawing(fields, settings.drawing, settings.saving); };
}

}  // namespace

const std::vector<Preset>& built_in_presets() {
    static const std::vector<Preset> presets = made_presets();
    return presets;
}

std::vector<std::string> own_presets(const fs::path& folder) {
    return preset_files(folder).names();
}

Preset preset_named(const std::string& name, const fs::path& folder) {
    const auto& built_in = built_in_presets();
    const auto found = std::ranges::find(built_in, name, &Preset::name);
    if (found != built_in.end()) return *found;
    const fs::path file = preset_files(folder).find(name);
    if (file.empty())
        throw failure("there is no preset \"{}\"; `dapple presets` lists them all", printable(name));
    Preset preset{name, "", {}};
    read_settings(text_of_settings(file), {file}, all_of_preset(preset.settings));
    return preset;
}

void save_preset(const std::string& name, const SavedSettings& settings, const fs::path& folder) {
    const NamedFiles files = preset_files(folder);
    SavedSettings written = settings;
    files.save(name, settings_text("", {files.path_of(name)}, all_of_preset(written)));
}

void remove_preset(const std::string& name, const fs::path& folder) {
    preset_files(folder).remove(name);
}

DrawingSettings with_preset(const DrawingSettings& preset, const DrawingSettings& present) {
    DrawingSettings drawing = preset;
    drawing.automatic_exposure = present.automatic_exposure;
    drawing.tone.exposure = present.tone.exposure;
    drawing.page.crop = present.page.crop;
    drawing.page.quarter_turns = present.page.quarter_turns;
    drawing.page.mirrored = present.page.mirrored;
    drawing.placing.threads = present.placing.threads;
    drawing.mask = present.mask;
    drawing.edits = present.edits;
    return drawing;
}

}  // namespace dapple
