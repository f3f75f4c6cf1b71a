#pragma once
// A session of the window whose view is split, at any zoom, and where its dots are.

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "app/viewer/model/compared_panes.h"
#include "tests/wait_until.h"

namespace dapple {

inline constexpr glm::dvec2 kCanvas{800, 600};

/// Goes on as the window does, frame by frame, until `done` says so; false if it never does.
template <class Done>
bool comes_to(Session& session, Done done) {
    return wait_until([&] {
        session.take_events(std::chrono::milliseconds(0));
        session.request_dots({.camera = fitted(kCanvas, {1, 1})});
        return done();
    });
}

/// A grey beside the paper's tile on the same grey.
struct SplitSession {
    Zoom zoom{.camera = fitted(kCanvas, {1, 1})};
    Session session;
    ComparedPanes compared{session, [] {}};

    explicit SplitSession(std::uint64_t dots, std::uint64_t most_dots = kMostDots)
        : session(
              DrawingSettings{}, [] {}, most_dots) {
        session.settings.density.source = DensitySource::grey;
        session.settings.drawing.placing.count = dots;
        session.settings.drawing.relax = 0;
        session.settings.comparison.on = true;
        session.open_sample();
        REQUIRE(brings([&] { return compared.right() != nullptr; }));
    }

    /// Goes on as the window does, frame by frame.
    void frame() {
        session.take_events(std::chrono::milliseconds(0));
        compared.take_events();
        session.request_dots(zoom);
        compared.request(zoom);
    }
    template <class Done>
    bool brings(Done done) {
        return wait_until([&] {
            frame();
            return done();
        });
    }

    void zoom_in(ZoomMode mode, double times) {
        const Camera fit = fitted(kCanvas, {1, 1});
        // Not about the middle, and not about a corner of a tile.
        zoom = {mode, zoomed_at(fit, kCanvas * glm::dvec2(0.37, 0.61), times), times};
        REQUIRE(brings([&] {
            const Pane* right = compared.right();
            const PageWindow window = window_in_view(zoom.camera, 0.3);
            if (!session.pane().shows_close() || session.pane().shown().window() != window) return false;
            if (!session.settings.comparison.on) return true;
            return right && right->shows_close() && right->shown().window() == window;
        }));
    }
};

/// The places of a close view's dots on the page, in order.
inline std::vector<glm::dvec2> places_of(const PlacedDrawing& shown) {
    const glm::dvec2 corner = in_page_units({shown.window().x, shown.window().y});
    std::vector<glm::dvec2> places;
    for_each_position(shown.dots, [&](float x, float y) { places.push_back(corner + glm::dvec2(x, y)); });
    return places;
}

inline void check_same(const std::vector<glm::dvec2>& found, const std::vector<glm::dvec2>& expected) {
    REQUIRE(found.size() == expected.size());
    double furthest = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        furthest =
            std::max({furthest, std::abs(found[i].x - expected[i].x), std::abs(found[i].y - expected[i].y)});
    CHECK(furthest < 1e-6);
}
}  // namespace dapple
