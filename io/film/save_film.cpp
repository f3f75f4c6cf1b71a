#include "io/film/save_film.h"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/file_ending.h"
#include "io/files/png_file.h"
#include "io/files/webp_film.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

bool is_film(const fs::path& path) {
    return ending_of(path) == ".webp";
}

// Where in the film a picture lies, 0..1.
double share_of(int frame, int frames) {
    return frames > 1 ? static_cast<double>(frame) / (frames - 1) : 1;
}

fs::path frame_file(const fs::path& folder, int frame) {
    return folder / fmt::format("frame-{:04}.png", frame + 1);
}

bool save_frames(const fs::path& folder, const FilmFrame& frame, int frames, const SavingWatch& watch) {
    make_folder(folder);
    for (int i = 0; i < frames; ++i) {
        if (watch.stop.stop_requested()) return false;
        const Grid<glm::u8vec3> pixels = frame(share_of(i, frames));
        save_next(static_cast<std::size_t>(i), [&] {
            save_atomically(frame_file(folder, i), [&](std::ostream& out) {
                write_png(out, {.width = pixels.width, .height = pixels.height, .dpi = 96},
                          [&](const PixelSink& sink) { sink(pixels); });
            });
        });
        if (watch.progress) watch.progress(static_cast<double>(i + 1) / frames);
    }
    return true;
}

}  // namespace

void check_film_path(const fs::path& path) {
    std::error_code ignored;
    const bool folder = !path.has_filename() || fs::is_directory(path, ignored);
    if (folder) return;
    if (is_film(path)) return check_can_save(path);
    throw std::runtime_error(printable(path.string()) +
                             ": a film's name ends in .webp, and in / for a folder of numbered PNG files");
}

std::vector<fs::path> files_of(const fs::path& path, const FilmChoice& choice) {
    if (is_film(path)) return {path};
    std::vector<fs::path> frames;
    for (int i = 0; i < frames_of(choice); ++i) frames.push_back(frame_file(path, i));
    return frames;
}

bool save_film(const fs::path& path, const FilmFrame& frame, const FilmChoice& choice,
               const SavingWatch& watch) {
    check_film_path(path);
    const int frames = frames_of(choice);
    if (!is_film(path)) return save_frames(path, frame, frames, watch);
    WebpFilm film(choice.frames_per_second);
    for (int i = 0; i < frames; ++i) {
        if (watch.stop.stop_requested()) return false;
        film.add(frame(share_of(i, frames)));
        if (watch.progress) watch.progress(static_cast<double>(i + 1) / frames);
    }
    save_atomically(path, [&](std::ostream& out) { film.write(out); });
    return true;
}

}  // namespace dapple
