#include "io/files/save_drawing.h"

#include <memory>
#include <stdexcept>
#include <vector>

#include "core/output/raster.h"
#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/pdf_file.h"
#include "io/files/png_file.h"
#include "io/files/separations.h"
#include "io/files/sheet_files.h"
#include "io/files/text_file.h"
#include "io/files/tiff_file.h"

namespace dapple {

DrawingFormat drawing_format(const std::filesystem::path& path) {
    if (const auto format = format_with_ending(ending_of(path))) return *format;
    throw std::runtime_error(path.string() + ": a drawing's name must end in " + drawing_endings());
}

namespace {

bool save(const DrawnPage& page, const PlannedDrawing& drawing, const DrawingFile& file,
          const std::filesystem::path& path, const Watch& watch) {
    DrawingToSave part = drawing_on(page, drawing, file, watch.stop);
    part.file.path = path;
    return !watch.stop.stop_requested() && save_drawing(part, watch);
}

}  // namespace

bool save_page(const PlannedDrawing& drawing, const DrawingFile& file, const Watch& watch) {
    const PageLayout layout = drawing.layout();
    if (!is_several(file.settings.sheets))
        return save(drawn_page(layout, file.saving), drawing, file, file.path, watch);
    const std::vector<Sheet> all = all_sheets(file.settings.sheets);
    double saved = 0;
    for (const Sheet& sheet : all) {
        const auto show = [&](double share) {
            if (watch.progress) watch.progress((saved + share) / static_cast<double>(all.size()));
        };
        if (!save(drawn_page(layout, sheet), drawing, file, sheet_file(file.path, name_of(sheet)),
                  {watch.stop, show}))
            return false;
        ++saved;
    }
    save_assembly_plan(file.path, layout.page, file.settings.sheets);
    return true;
}

namespace {

bool is_grey(glm::vec3 colour) {
    return colour.r == colour.g && colour.g == colour.b;
}

// Thrown from within a writer to leave it.
struct Stopped {};

template <class Channel>
void write_pixels(std::ostream& out, const DrawingFile& file, const InkPage& page,
                  const WritingProgress& progress) {
    const DrawingSettings& settings = file.settings;
    const RasterSize size = raster_size(page.size, file.saving.dpi);
    const bool grey = page.pens.empty() && is_grey(settings.ink) && is_grey(settings.paper);
    const PngHeader header{size.width,
                           size.height,
                           file.saving.dpi,
                           grey ? PngColours::grey : PngColours::rgb,
                           {{kPngSettingsKeyword, file.embedded}}};
    const DrawInto<Channel> draw = [&](const SinkOf<Channel>& pixels) {
        rasterise(page, {.dpi = file.saving.dpi, .threads = settings.placing.threads},
                  [&](int first_row, std::span<const Grid<float>> coverage) {
                      if (progress) progress(static_cast<double>(first_row) / size.height);
                      pixels(ink_on_paper<Channel>(coverage, page, settings.paper));
                  });
    };
    if (file.format == DrawingFormat::png) return write_png<Channel>(out, header, draw);
    write_tiff<Channel>(out, header, draw);
}

}  // namespace

void write_drawing(std::ostream& out, const DrawingToSave& drawing, const std::string& title,
                   const WritingProgress& progress) {
    const DrawingFormat format = drawing.file.format;
    const InkPage page = ink_page(drawing);
    if (is_text(format)) return write_as(format, out, page, progress);
    if (format == DrawingFormat::pdf) return write_pdf(out, page, title, progress);
    const bool deep = drawing.file.saving.bits == 16;
    (deep ? write_pixels<std::uint16_t> : write_pixels<std::uint8_t>)(out, drawing.file, page, progress);
}

bool save_drawing(const DrawingToSave& drawing, const Watch& watch) {
    const DotOrder order = order_of(drawing);
    if (order == DotOrder::recursion) return save_ordered(drawing, watch);
    // Half of the progress is the pen's way.
    const double routing = order == DotOrder::shortest ? 0.5 : 0;
    const auto tell = [&](double share) {
        if (watch.progress) watch.progress(share);
    };
    auto sorted = std::make_shared<const DotPieces>(sorted_by_pen(
        drawing.dots, order, {.stop = watch.stop, .progress = [&](double share) { tell(routing * share); }}));
    if (watch.stop.stop_requested()) return false;
    DrawingToSave ordered = drawing;
    ordered.dots = stream_of(std::move(sorted), drawing.dots.scale);
    return save_ordered(ordered, {watch.stop, [&](double share) { tell(routing + (1 - routing) * share); }});
}

bool save_ordered(const DrawingToSave& drawing, const Watch& watch) {
    const std::filesystem::path& path = drawing.file.path;
    const DrawingFormat format = drawing.file.format;
    const SavingChoice& saving = drawing.file.saving;
    const bool to_standard_output = path == kStandardStream;
    const std::string title = to_standard_output ? "Drawing" : printable(path.stem().string());
    const WritingProgress progress = [&](double share) {
        if (watch.stop.stop_requested()) throw Stopped();
        if (watch.progress) watch.progress(share);
    };
    const auto write = [&](std::ostream& out) {
        write_drawing(out, drawing, title, progress);
        progress(1);
    };
    const auto for_each_pen = [&](std::size_t before, const auto& write_pen) {
        for (std::size_t pen = 0; pen < drawing.pens.size(); ++pen)
            save_next(pen + before, [&] {
                save_atomically(file_of_pen(path, pen, drawing.pens[pen]),
                                [&](std::ostream& out) { write_pen(out, pen); });
            });
    };
    try {
        if (to_standard_output) {
            write_to_standard_output(write);
        } else if (has_pen_files(format, saving, drawing.pens)) {
            for_each_pen(0, [&](std::ostream& out, std::size_t pen) {
                const auto done = static_cast<double>(pen), pens = static_cast<double>(drawing.pens.size());
                write_drawing(out, drawing_of_pen(drawing, pen), title,
                              [&](double share) { progress((done + share) / pens); });
            });
            progress(1);
        } else {
            save_atomically(path, write);
            if (has_separations(format, saving, drawing.pens))
                for_each_pen(1, [&](std::ostream& out, std::size_t pen) {
                    write_separation(out, drawing, pen, progress);
                });
        }
    } catch (const Stopped&) {
        return false;
    }
    return true;
}

}  // namespace dapple
