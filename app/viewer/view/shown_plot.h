#pragma once
// A drawing on screen as far as a machine has plotted it.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/background/dots_request.h"
#include "core/drawing/settings.h"
#include "io/film/film.h"

namespace dapple {

class ShownPlot {
 public:
    /// `wake` is called from another thread once the machine's way is found.
    explicit ShownPlot(std::function<void()> wake) : finding_(std::move(wake)) {}

    /// Finds the machine's way through the drawing in the background, if that is another than before: the
    /// number and the settings say so.
    void prepare(std::uint64_t placing, const PlacedDrawing& page, const DrawingSettings& settings,
                 const SavingChoice& saving);
    /// Null while it is being found.
    const PlotFilm* film() const { return film_ ? &film_->plot : nullptr; }
    /// Changes with the film.
    int films() const { return films_; }

    /// What is drawn of it after so many dots, or points of strokes. `page` is what prepare() was given.
    PlacedDrawing drawn(const PlacedDrawing& page, std::size_t count) const;
    /// Where the pen has been, the last place at the end, page units from the picture's corner.
    std::vector<glm::dvec2> trail(std::size_t count) const;

    void forget();

 private:
    struct Asked {
        std::uint64_t placing = 0;
        DrawingSettings settings;
        Machine machine = Machine::axidraw_v3;
        std::optional<DotOrder> order;
        bool operator==(const Asked&) const = default;
    };
    struct Found {
        PlotFilm plot;
        Palette pens;
        double mm_per_page_unit = 1, pen_width_mm = 0;
        std::vector<double> pen_widths_mm = {};
    };

    std::optional<Asked> asked_, begun_;  // the latter is being found
    std::optional<Found> film_;
    int films_ = 0;
    Background<Found> finding_;
};

}  // namespace dapple
