#include "app/viewer/model/compared_panes.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/common.hpp>
#include <variant>

namespace dapple {

namespace {

PointsInView points_on_screen(const PlacedDrawing& shown, const Camera& camera) {
    const PageWindow view = window_in_view(camera, 0);
    // Relative to the dots' origin, which may lie deep within the page.
    const PagePoint origin{shown.window().x, shown.window().y};
    const glm::dvec2 low = in_page_units(PagePoint{view.x, view.y} - origin);
    const glm::dvec2 page_end = shown.plan.picture_size() - in_page_units(origin);
    const glm::dvec2 high = glm::min(low + glm::dvec2(view.width, view.height), page_end);
    return points_in_view(shown.dots, {low, high}, kMostAnalysed, shown.blocks);
}

}  // namespace

void ViewMeter::update(const Pane& pane, const Camera& camera, std::size_t tile_size) {
    try {
        if (std::optional<ViewAnalysis> result = background_.result()) {
            analysis_ = std::move(result);
            ++analyses_;
        }
    } catch (const std::exception& error) {
        analysis_.emplace().error = error.what();
        ++analyses_;
    }
    const std::pair key(pane.placings(), camera);
    if (measured_ == key || background_.busy()) return;
    background_.begin(analysis_work({.view = points_on_screen(pane.shown(), camera),
                                     .tile_size = tile_size,
                                     .has_duplicates = pane.page().duplicates > 0,
                                     .measure = measure_}));
    measured_ = key;
}

void ViewMeter::stop() {
    background_.stop();
    measured_.reset();
}

std::optional<double> ViewMeter::periodicity() const {
    if (!analysis_ || !analysis_->periodicity) return std::nullopt;
    return analysis_->periodicity->value;
}

namespace {

// Beside a left one that has been placed.
DotsRequest right_request(const Comparison& comparison, const PlacedDrawing& left) {
    DotsRequest right = *left.request;
    right.drawing.placer = comparison.placer;
    right.drawing.tile = comparison.tile;
    right.drawing.ranking = comparison.ranking;
    right.drawing.placing.count.reset();
    if (comparison.by == CompareBy::count)
        right.drawing.placing.count = std::max<std::uint64_t>(left.dots.size() - left.duplicates, 1);
    // A drawing of exactly so many dots ends just on its scale; the last of them lies within the next.
    right.drawing.placing.scale = std::nextafter(static_cast<float>(left.scale), INFINITY);
    return right;
}

}  // namespace

void ComparedPanes::Beside::request(const Session& session, DotsRequest page, const Zoom& zoom) {
    if (std::exchange(asked_, session.pictures()) != session.pictures())
        pane_.worker().open(session.picture().name, session.picture().read);
    pane_.request(std::move(page), zoom, session.settings.every_frame);
}

void ComparedPanes::Beside::forget() {
    if (asked_ == 0) return;
    pane_.clear();
    asked_ = there_ = 0;
}

std::string ComparedPanes::Beside::take_events() {
    std::string trouble;
    for (WorkerEvent& event : pane_.worker().events()) {
        if (auto* placed = std::get_if<DotsPlaced>(&event); placed && asked_ > 0) {  // or too late
            if (!placed->error.empty()) trouble = placed->error;
            if (placed->picture) there_ = asked_;
            pane_.take(*placed);
        } else if (const auto* failed = std::get_if<TaskFailed>(&event)) {
            trouble = failed->message;
        }
    }
    return trouble;
}

ComparedPanes::ComparedPanes(Session& session, const std::function<void()>& wake)
    : session_(session),
      right_(wake),
      was_(wake),
      as_it_was_(session.settings.drawing),
      meters_{ViewMeter(Measure::repetition, wake), ViewMeter(Measure::repetition, wake)} {}

void ComparedPanes::hold(std::optional<SeenInstead> held) {
    held_ = held;
    if (toggled_ && (held_ || toggled_at_ != session_.settings.drawing)) toggled_.reset();
}

void ComparedPanes::toggle(SeenInstead what) {
    if (std::exchange(toggled_, std::nullopt) == what) return;
    const DrawingSettings& now = session_.settings.drawing;
    if (what == SeenInstead::as_it_was && as_it_was_ == now) {
        session_.banner = {BannerKind::notice, "Nothing to compare yet: the drawing is unchanged"};
        return;
    }
    toggled_ = what;
    toggled_at_ = now;
    session_.banner = {BannerKind::notice,
                       what == SeenInstead::photograph
                           ? "This is the photograph; press C or Escape for the drawing"
                           : "This is the drawing as it was; press W or Escape for the current one"};
}

bool ComparedPanes::end_toggled() {
    return std::exchange(toggled_, std::nullopt).has_value();
}

void ComparedPanes::keep() {
    as_it_was_ = session_.settings.drawing;
    session_.banner = {BannerKind::notice, "Kept. Hold W to see these settings"};
}

void ComparedPanes::take_events() {
    if (std::exchange(pictures_, session_.pictures()) != session_.pictures()) {
        was_.forget();
        as_it_was_ = session_.settings.drawing;
    }
    for (Beside* const beside : {&right_, &was_})
        if (const std::string trouble = beside->take_events(); !trouble.empty()) session_.say(trouble);
}

void ComparedPanes::request(const Zoom& zoom) {
    take_events();  // another picture may have come since
    const ViewerSettings& settings = session_.settings;
    const PlacedDrawing& left = session_.pane().page();
    if (!settings.comparison.on)
        right_.forget();
    else if (left.request)
        right_.request(session_, right_request(settings.comparison, left), zoom);
    if (!left.request || !wants_as_it_was()) return;
    ViewerSettings was = settings;
    was.drawing = as_it_was_;
    was_.request(session_, session_.as_shown(dots_request(was)), zoom);
}

// Without a change there is nothing else to see.
bool ComparedPanes::wants_as_it_was() const {
    return instead() == SeenInstead::as_it_was && !session_.film && as_it_was_ != session_.settings.drawing;
}

const Pane& ComparedPanes::seen() const {
    const Pane* const was = wants_as_it_was() ? was_.of_picture(session_.pictures()) : nullptr;
    return was ? *was : session_.pane();
}

const Pane* ComparedPanes::right() const {
    return session_.settings.comparison.on ? right_.of_picture(session_.pictures()) : nullptr;
}

const Pane& ComparedPanes::at(float share) const {
    const Pane* const right = this->right();
    return right && share >= session_.settings.comparison.divider ? *right : seen();
}

std::vector<const Pane*> ComparedPanes::panes() const {
    std::vector<const Pane*> panes{&session_.pane()};
    for (const Pane* const beside : {right_.in_use(), was_.in_use()})
        if (beside) panes.push_back(beside);
    return panes;
}

const DrawingSettings& ComparedPanes::settings_of(const Pane& pane) const {
    return &pane == was_.in_use() ? as_it_was_ : session_.settings.drawing;
}

std::size_t ComparedPanes::tile_size() const {
    const std::size_t left = seen().tile_size();
    return right() ? std::min(left, right()->tile_size()) : left;
}

void ComparedPanes::measure(const Camera& camera) {
    if (!right()) return;
    meters_[0].update(session_.pane(), camera, tile_size());
    meters_[1].update(*right(), camera, tile_size());
}

std::optional<double> ComparedPanes::periodicity(const Pane& pane) const {
    if (&pane == was_.in_use()) return std::nullopt;
    return meters_[&pane == right() ? 1 : 0].periodicity();
}

}  // namespace dapple
