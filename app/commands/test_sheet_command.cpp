// dapple testsheet: a page to plot, from which the dot gain of pens is read off.

#include "app/commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands/settings_options.h"
#include "core/drawing/settings.h"
#include "core/drawing/write_drawing.h"
#include "core/output/pen_figures.h"
#include "core/output/test_sheet.h"
#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/save_drawing.h"

namespace dapple {

namespace {

struct TestSheetOptions {
    DrawingSettings drawing;
    SavingChoice saving;
    std::filesystem::path output;
};

// In the order in which a drawing has them.
Palette pens_to_test(const PenChoice& choice) {
    if (choice.set == PenSet::one)
        throw CLI::ValidationError("--pens", "one has no width or name; give a pen such as Black:#000:0.3");
    if (choice.set == PenSet::automatic)
        throw CLI::ValidationError("--pens", "auto chooses pens for a picture, and there is none; name them");
    Palette pens = palette_of(choice);
    sort_pens(pens, choice.order);
    return pens;
}

glm::dvec2 size_of(const PageSetup& page) {
    if (page.paper == Paper::custom) return {page.width_mm, page.height_mm.value_or(page.width_mm)};
    return paper_size(page.paper);
}

void save(const TestSheetOptions& options) {
    const DrawingFormat format = drawing_format(options.output);
    if (is_table(format))
        throw CLI::ValidationError(
            "--output", options.output.string() + ": a table has no lines; let it end in .svg or .pdf");
    const Palette pens = pens_to_test(options.drawing.pens);
    const glm::dvec2 size = size_of(options.drawing.page);
    const PageSize page{size.x, size.y, std::max(size.x, size.y)};
    TestSheet sheet;
    told_as("--pens", [&] { sheet = test_sheet(pens, page); });
    check_can_save(options.output);
    StrokeStream strokes = stream_of(sheet.strokes, options.drawing.pen_width_mm);
    for (const Pen& pen : pens) strokes.widths_mm.push_back(pen.width_mm);
    DrawingToSave drawing{.file = {.path = options.output,
                                   .format = format,
                                   .settings = options.drawing,
                                   .saving = options.saving},
                          .dots = {},
                          .page = page,
                          .pens = pens,
                          .strokes = strokes};
    drawing.dots.count = sheet.dots;
    save_ordered(drawing);  // each pen's dots as they were laid out
    const Machine machine = usual_machine(format, options.saving.tool);
    const PlottingTime time = figures_of(strokes, program_for(machine, drawing).program).time;
    fmt::print(stderr, "{}: {} {}, {} dots", printable(options.output.string()), pens.size(),
               pens.size() == 1 ? "pen" : "pens", grouped(sheet.dots));
    if (is_plotted(format))
        fmt::print(stderr, "; {} on {}", time_in_words(time.total_s()), words_for(machine));
    fmt::print(stderr, "\n");
}

}  // namespace

Command add_test_sheet_command(CLI::App& program) {
    const auto kept = std::make_shared<TestSheetOptions>();
    TestSheetOptions& options = *kept;
    options.drawing.page.paper = Paper::a4;
    options.drawing.registration = true;
    CLI::App* const command = program.add_subcommand(
        "testsheet", "Make a page of dots and tones, which shows how wide your pens' dots become");
    add_pens(*command, options.drawing.pens,
             "The pens, as for dapple render, each with a width, as in cmyk:0.3 or "
             "Sky:#3aa0d8:0.3,Ochre:#c08a2e:0.5")
        ->required();
    command
        ->add_option("-o,--output", options.output,
                     "The page; its name ends in .svg, .pdf, .png, .tif, .gcode, .nc, .hpgl, .plt or .dxf")
        ->type_name("OUT")
        ->required();
    add_paper(*command, options.drawing.page,
              "A paper: a4 to a0, letter, legal, tabloid and so on, or a size such as 210x297")
        ->default_str("a4");
    add_gcode_options(*command, options.saving);
    command->footer(
        "Each pen draws ten single dots, pairs of dots, and six tones. The number below a pair is the gap\n"
        "in millimetres between its dots if they were as wide as the pen. They are wider: the last gap that\n"
        "is closed is the pen's dot gain. Give it after the width, as in 0.3+0.06, or in the window; tones\n"
        "are then as dark as the picture's. The numbers at the tones are per cent of ink: with the right\n"
        "gain, the one of 100 has just no paper left.\n\n"
        "Examples:\n"
        "  dapple testsheet --pens cmyk:0.3 -o sheet.svg\n"
        "  dapple testsheet --pens 'Red:#c1121f:0.5,Black:#000:0.3' --page letter -o sheet.hpgl\n"
        "  dapple render cat.jpg --pens cmyk:0.3+0.06 -o cat.svg      with the gain found");
    command->callback([&options, command] {
        if (drawing_format(options.output) != DrawingFormat::gcode)
            refuse(
                *command,
                {"--gcode", "--feed", "--dwell", "--acceleration", "--pen-up", "--pen-down", "--laser-power"},
                "applies to G-code only; let the name end in .gcode or .nc");
        check_apart(*command, {"--output"}, {{options.output, "the page"}});
        save(options);
    });
    return kept;
}

}  // namespace dapple
