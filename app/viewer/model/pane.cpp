#include "app/viewer/model/pane.h"

#include <cmath>
#include <utility>

namespace dapple {

std::uint32_t hidden_among(std::span<const Pen> pens, const ShownPens& shown) {
    const bool alone = std::ranges::find(pens, shown.only, &Pen::name) != pens.end();
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < pens.size(); ++i) {
        const std::string& name = pens[i].name;
        if (alone ? name != shown.only : shown.hidden.contains(name)) bits |= std::uint32_t{1} << i;
    }
    return bits;
}

namespace {

// Pixels per page unit from which only what is in view is placed: before, a float on the page is as good as a
// hundredth of a pixel.
constexpr double kCloseZoom = 0x1p15;
// Dots that fade in are paler than they will be; so many more of them make up for it.
constexpr double kFadeHeadStart = 1.07;

}  // namespace

std::optional<CloseView> Pane::close_view(const DotsRequest& page, const Zoom& zoom) const {
    const bool constant_density = zoom.mode == ZoomMode::constant_density;
    // Figure 8 places whole drawings only.
    if (page.drawing.placer != PlacerKind::exact) return {};
    // Edits are of the page's own dots.
    if (!page.drawing.edits.empty()) return {};
    // Relaxed dots are those of the page at any zoom.
    const bool moved = page_.plan.steps > 0;
    if (!constant_density && (moved || zoom.camera.pixels_per_unit < kCloseZoom)) return {};
    // A drawing of exactly so many dots ends just on its scale; the last of them lies within the next.
    double scale = std::nextafter(static_cast<float>(page_.scale), INFINITY);
    if (constant_density) scale *= kFadeHeadStart * zoom.enlargement * zoom.enlargement;
    return CloseView{window_in_view(zoom.camera, 0.3), scale};
}

double Pane::fade_scale(const Zoom& zoom) const {
    if (!shows_close_ || zoom.mode != ZoomMode::constant_density) return 0;
    return page_.scale * zoom.enlargement * zoom.enlargement * kFadeHeadStart;
}

bool Pane::request(DotsRequest page, const Zoom& zoom, bool again) {
    const auto close = close_view(page, zoom);
    if (!close && close_requested_) {
        close_requested_.reset();
        shows_close_ = false;
        ++version_;
        // A close view has stopped the page's dots on their way.
        if (!page_.settled()) page_requested_.reset();
    }
    // The whole drawing comes first: its scale is what a close view starts from.
    const bool is_close = close && page_requested_ == page && page_.request == page;
    if (is_close) page.close = close;
    std::optional<DotsRequest>& requested = is_close ? close_requested_ : page_requested_;
    if (!again && requested == page) return false;
    // A hand that rests on a control changes nothing.
    const bool held = std::exchange(page.held, false);
    if (held && !again && requested == page) return false;
    page.held = held;
    requested = page;
    worker_.place(std::move(page));
    return true;
}

void Pane::take(DotsPlaced& event) {
    if (event.tile) {
        tile_ = std::move(*event.tile);
        ++tiles_;
    }
    if (event.drawing.request->close) {
        if (close_requested_) {
            std::swap(close_, event.drawing);
            shows_close_ = true;
        }
    } else {
        if (event.picture) shows_close_ = false;
        std::swap(page_, event.drawing);
        if (close_requested_) close_requested_->close = CloseView{};  // to be requested again
    }
    worker_.recycle(std::move(event.drawing));
    ++version_;
    ++placings_;
}

void Pane::clear() {
    page_requested_.reset();
    close_requested_.reset();
    worker_.recycle(std::exchange(page_, {}));
    worker_.recycle(std::exchange(close_, {}));
    worker_.clear();
    shows_close_ = false;
    ++version_;
}

}  // namespace dapple
