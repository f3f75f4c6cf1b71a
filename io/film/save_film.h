#pragma once
// A film into a file.

#include <filesystem>
#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <ostream>
#include <vector>

#include "core/image/grid.h"
#include "core/watch.h"
#include "io/files/save_drawing.h"
#include "io/film/film.h"

namespace dapple {

// Moving pictures as an animated WebP, pixel for pixel.

class WebpFilm {
 public:
    /// It is played over and over.
    explicit WebpFilm(int frames_per_second);
    ~WebpFilm();

    /// sRGB-encoded; all as large, up to 16,383 pixels a side. Throws std::runtime_error if libwebp fails.
    void add(const Grid<glm::u8vec3>& frame);
    /// All of them. Needs one at least. Throws std::runtime_error if libwebp fails, and what the stream does.
    void write(std::ostream& out);

 private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

/// "Animation.webp" is one file, which web browsers play, over and over; "frames/", which ends in a slash or
/// is there, a folder of numbered PNG files for a program that makes films of them: frame-0001.png, ...
/// Throws std::runtime_error naming the path if it is neither, or cannot be written.
void check_film_path(const std::filesystem::path& path);

/// All that save_film() writes there.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& path, const FilmChoice& choice);

/// Returns false if stopped; then a film that was at that place is still there, while of a folder's frames
/// those that were written stay. Throws what check_film_path(), save_atomically() and the frames throw.
bool save_film(const std::filesystem::path& path, const FilmFrame& frame, const FilmChoice& choice,
               const Watch& watch = {});

}  // namespace dapple
