// The histogram's handles, dragged without a window.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/panels/settings_panels.h"
#include "core/image/ink.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

Histogram some_histogram() {
    Histogram histogram;
    for (int i = 0; i <= Histogram::kSteps; ++i) histogram.counts[i] = (i % 37) * (i % 11);
    for (auto count : histogram.counts) histogram.total += count;
    return histogram;
}

struct HistogramUi {
    Tone tone;
    Histogram histogram = some_histogram();
    bool changed = false;
    HeadlessUi ui{[this] { changed |= draw_histogram(histogram, tone); }};

    glm::vec2 centre(const std::string& handle) const { return ui.at(handle, 0.5f); }
    float x_of(float encoded) const {
        const WidgetPlace all = ui.place("Histogram");
        const WidgetPlace black = ui.place("Black point handle");
        const float margin = (black.max.x - black.min.x) / 2;
        return all.min.x + margin + (all.max.x - all.min.x - 2 * margin) * encoded;
    }
    void drag_to(const std::string& handle, float x) {
        ui.move_to(centre(handle));
        ui.press();
        ui.move_to({(centre(handle).x + x) / 2, centre(handle).y});
        ui.move_to({x, centre(handle).y});
        ui.release();
        ui.frame(1);
    }
};

}  // namespace

TEST_CASE("each handle of the histogram changes its own setting") {
    HistogramUi f;
    f.drag_to("Black point handle", f.x_of(0.2f));
    CHECK(f.tone.black_point == doctest::Approx(0.2).epsilon(0.02));
    CHECK(f.tone == Tone{.black_point = f.tone.black_point});
    f.drag_to("White point handle", f.x_of(0.8f));
    CHECK(f.tone.white_point == doctest::Approx(0.8).epsilon(0.02));
    CHECK(f.tone.gamma == 1);
    const Tone levels = f.tone;
    f.drag_to("Middle handle", f.x_of(0.5f));
    // Half way between the points lies 0.5, and 0.5^(1/gamma) is half of white's light, encoded.
    CHECK(f.tone.gamma == doctest::Approx(std::log(0.5) / std::log(0.73536)).epsilon(0.03));
    CHECK(f.tone.black_point == levels.black_point);
    CHECK(f.tone.white_point == levels.white_point);
    CHECK(f.changed);
}

TEST_CASE("the keys walk to each handle and move it") {
    HistogramUi f;
    f.ui.key(Key::tab);
    f.ui.key(Key::right);
    CHECK(f.tone.black_point == doctest::Approx(0.01));
    f.ui.key(Key::tab);
    f.ui.key(Key::tab);
    f.ui.key(Key::left);
    CHECK(f.tone.white_point == doctest::Approx(0.99));
}

TEST_CASE("at the middle handle ink covers half of the paper") {
    for (const Tone& tone : {Tone{}, Tone{.gamma = 2.4f}, Tone{.black_point = 0.2f, .white_point = 0.7f},
                             Tone{.black_point = 0.1f, .gamma = 0.6f, .invert = true}}) {
        const Grid<float> light(1, 1, srgb_to_linear(middle_of(tone)));
        CHECK(InkCurve().coverage(density_of(light, tone).at(0, 0)) == doctest::Approx(0.5).epsilon(0.01));
    }
}

TEST_CASE("black stays below white, and no handle leaves its range") {
    HistogramUi f;
    f.drag_to("Black point handle", 399);
    CHECK(f.tone.black_point == doctest::Approx(0.99));
    f.drag_to("Black point handle", 0);
    CHECK(f.tone.black_point == 0);
    f.drag_to("Black point handle", f.x_of(0.4f));
    f.drag_to("White point handle", 0);
    CHECK(f.tone.white_point == doctest::Approx(f.tone.black_point + 0.01));
    f.drag_to("White point handle", 399);
    CHECK(f.tone.white_point == 1);
    f.drag_to("Middle handle", 399);
    CHECK(f.tone.gamma == 0.25f);
    f.drag_to("Middle handle", 0);
    CHECK(f.tone.gamma == 4);
}

TEST_CASE("a handle that is pressed but not moved changes nothing, even beyond the sliders") {
    HistogramUi f;
    f.tone = {.black_point = 0.123f, .white_point = 0.876f, .gamma = 7};
    const Tone before = f.tone;
    f.ui.frame();
    for (const char* handle : {"Black point handle", "Middle handle", "White point handle"}) {
        f.ui.move_to(f.centre(handle) + glm::vec2(2, 0));
        f.ui.press();
        f.ui.frame();
        f.ui.release();
        f.ui.frame(1);
    }
    CHECK(f.tone == before);
    CHECK_FALSE(f.changed);
}

TEST_CASE("a press in the bars takes the nearest handle there, and it follows a mouse that leaves") {
    HistogramUi f;
    const glm::vec2 place{f.x_of(0.15f), f.ui.at("Histogram", 0).y};
    f.ui.move_to(place);
    f.ui.press();
    f.ui.frame();
    CHECK(f.tone.black_point == doctest::Approx(0.15).epsilon(0.02));
    f.ui.move_to({f.x_of(0.3f), 700});
    CHECK(f.tone.black_point == doctest::Approx(0.3).epsilon(0.02));
    f.ui.release();
    f.ui.move_to({f.x_of(0.1f), 700});
    CHECK(f.tone.black_point == doctest::Approx(0.3).epsilon(0.02));
}

TEST_CASE("points that the sliders left meeting, and an empty histogram, do no harm") {
    HistogramUi f;
    f.histogram = {};
    f.tone = {.black_point = 1, .white_point = 1};
    f.drag_to("White point handle", 0);
    CHECK(f.tone.black_point <= 1);
    CHECK(f.tone.white_point <= 1);
    f.tone = {.black_point = 0, .white_point = 0};
    f.ui.frame();
    f.drag_to("Middle handle", 200);
    CHECK(f.tone.gamma >= 0.25f);
    CHECK(f.tone.gamma <= 4);
}

TEST_CASE("the histogram is as wide as its panel and about four text lines high") {
    HistogramUi f;
    const WidgetPlace place = f.ui.place("Histogram");
    CHECK(place.max.x - place.min.x > 350);
    CHECK(place.max.y - place.min.y < 6 * ImGui::GetTextLineHeight());
    CHECK(place.max.y - place.min.y > 4 * ImGui::GetTextLineHeight());
}

}  // namespace dapple
