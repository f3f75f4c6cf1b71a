#pragma once
// What is done in the background for one side of the canvas: pictures read, dots placed and relaxed, drawings
// prepared for a file. One piece of work at a time uses it.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/files/picture.h"
#include "app/files/save_drawing.h"
#include "app/viewer/model/background.h"
#include "app/viewer/model/spare_drawings.h"
#include "app/viewer/model/tile_view.h"
#include "app/viewer/model/workbench.h"

namespace dapple {

/// A picture that was opened; its light stays with the bench.
struct OpenedPicture {
    std::filesystem::path file = {};                                // none: not from one
    std::string name;                                               // for the title: "cat.png"
    std::string description;                                        // "512 x 512 pixels, ..."
    int longer_side = 1;                                            // pixels
    std::shared_ptr<const std::vector<Grid<glm::u8vec4>>> preview;  // mipmaps_of() it
    float exposure = 0;                                             // see Picture
    std::function<Picture()> read;                                  // reads it again
    /// Twice as wide as high and in parts brighter than paper, as environment maps are.
    bool looks_like_environment = false;
};

/// A new picture comes together with its first dots. A drawing whose dots are still to be relaxed comes as it
/// lies, and again when it has settled further.
struct DotsPlaced {
    DotsRequest request;
    PlacedDrawing drawing;
    std::optional<OpenedPicture> picture;
    std::optional<TileView> tile;  // if it is another than the one told before
    std::string error;             // why there are no dots
};

/// Writes a file; false if stopped.
using WriteFile = std::function<bool(const SavingWatch&)>;
/// Places what is to be written. Empty if stopped.
using PrepareFile = std::function<WriteFile(Workbench&, std::stop_token)>;

struct FilePrepared {
    WriteFile write;
};

class PlacingBench {
 public:
    using Result = std::variant<DotsPlaced, FilePrepared>;
    using Task = Background<Result>::Task;

    bool has_picture() const { return workbench_.has_picture(); }

    /// Shows what `read` returns from now on. If it throws, the old picture stays.
    void open(const std::string& name, const std::function<Picture()>& read,
              const std::filesystem::path& file);

    /// Nothing if stopped. What goes wrong is in DotsPlaced::error.
    std::optional<Result> place(const DotsRequest& request, const Task& task);

    std::optional<Result> prepare(const PrepareFile& prepare, const Task& task);

    /// Forgets picture and dots and gives their memory back.
    void clear();

    SpareDrawings& spare() { return spare_; }
    /// Gives back the memory of spare drawings, or keeps it for the next.
    void sort_spare() { spare_.sort(last_size_); }

 private:
    DotsPlaced ready_for_screen(const DotsRequest& request, PlacedDrawing drawing);

    Workbench workbench_;
    std::optional<OpenedPicture> arrived_;  // waits for its dots
    SpareDrawings spare_;
    std::size_t last_size_ = 0;                  // dots of the last drawing
    std::optional<DotsRequest> tile_published_;  // the request whose tile was told last
};

/// What the exception being handled says, in words for people.
std::string words_of_exception();

}  // namespace dapple
