#pragma once
// What a session's drawing is compared with: the right side of the split view, the drawing as it was, the
// photograph. The first two have workers with a picture of their own, so that no drawing waits for another.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/model/pane.h"
#include "app/viewer/model/session.h"
#include "app/viewer/view/view_analysis.h"

namespace dapple {

// Measures the dots on screen in the background, again whenever they are others.

class ViewMeter {
 public:
    ViewMeter(Measure measure, std::function<void()> wake)
        : measure_(measure), background_(std::move(wake)) {}

    /// To be called each frame while somebody looks. Measures the dots on screen when they are others than
    /// before and the last measuring is over.
    void update(const Pane& pane, const Camera& camera, std::size_t tile_size);
    /// Nobody looks any more: gives up what is under way.
    void stop();

    /// None before the first.
    const std::optional<ViewAnalysis>& analysis() const { return analysis_; }
    /// ViewAnalysis::periodicity's value.
    std::optional<double> periodicity() const;
    /// How many there have been.
    int analyses() const { return analyses_; }

 private:
    Measure measure_;
    Background<ViewAnalysis> background_;
    std::optional<std::pair<std::uint64_t, Camera>> measured_;  // of Pane::placings()
    std::optional<ViewAnalysis> analysis_;
    int analyses_ = 0;
};

enum class SeenInstead { photograph, as_it_was };

class ComparedPanes {
 public:
    /// The session has to stay. `wake`: as it has it.
    ComparedPanes(Session& session, const std::function<void()>& wake);

    /// To be called each frame, with what a key holds in the drawing's place.
    void hold(std::optional<SeenInstead> held);
    /// Without a key: until it is asked for again, a key is held, or the settings change.
    void toggle(SeenInstead what);
    /// Ends that. False: there was nothing to end.
    bool end_toggled();
    std::optional<SeenInstead> instead() const { return held_ ? held_ : toggled_; }

    /// The settings as they were when the picture was opened, or when they were kept last.
    const DrawingSettings& as_it_was() const { return as_it_was_; }
    void keep();

    /// After Session::take_events().
    void take_events();
    /// After Session::request_dots(). Nobody waits for these; while the right side is not shown it keeps
    /// neither picture nor dots.
    void request(const Zoom& zoom);

    /// What the canvas shows, or the left side of the split view: the drawing, or as it was, once that is
    /// wanted and there.
    const Pane& seen() const;
    /// None unless the view is split, and before its first dots.
    const Pane* right() const;
    /// Where it is so far across the canvas, 0..1.
    const Pane& at(float share) const;
    /// All that may be placing.
    std::vector<const Pane*> panes() const;
    /// What a pane's drawing is drawn with; the right side has a tile of its own.
    const DrawingSettings& settings_of(const Pane& pane) const;
    const Session& session() const { return session_; }

    /// Both sides are measured by the smaller tile, so that they compare.
    std::size_t tile_size() const;
    /// Measures both sides on screen, while there are two: see ViewAnalysis::periodicity.
    void measure(const Camera& camera);
    /// None before, and of the drawing as it was.
    std::optional<double> periodicity(const Pane& pane) const;

 private:
    /// Another drawing of the picture, which is known by its number in the session.
    class Beside {
     public:
        explicit Beside(const std::function<void()>& wake) : pane_(wake) {}

        void request(const Session& session, DotsRequest page, const Zoom& zoom);
        /// Keeps neither picture nor dots until it is requested again.
        void forget();
        /// What went wrong; empty: nothing.
        std::string take_events();
        /// None before a request.
        const Pane* in_use() const { return asked_ > 0 ? &pane_ : nullptr; }
        /// None before the first dots of that picture.
        const Pane* of_picture(int number) const { return there_ > 0 && there_ == number ? &pane_ : nullptr; }

     private:
        Pane pane_;
        int asked_ = 0, there_ = 0;  // 0: none
    };

    bool wants_as_it_was() const;

    Session& session_;
    Beside right_, was_;  // as it was: kept for the next look until another picture comes
    DrawingSettings as_it_was_;
    int pictures_ = 0;  // the number of the one that it was so for
    std::optional<SeenInstead> held_, toggled_;
    DrawingSettings toggled_at_;
    std::array<ViewMeter, 2> meters_;
};

}  // namespace dapple
