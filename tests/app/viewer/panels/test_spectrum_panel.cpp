// The spectrum section, without a window.

#include <doctest/doctest.h>

#include <string>

#include "app/viewer/panels/method_panels.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

ViewAnalysis some_analysis() {
    ViewAnalysis analysis;
    analysis.dots = 5000;
    for (int i = 1; i <= 100; ++i) {
        Ring& ring = analysis.radial_power.emplace_back();
        ring.frequency = i * 0.02;
        ring.power = i * 0.1;
    }
    analysis.periodicity.emplace().value = 0.95;
    return analysis;
}

struct SpectrumUi {
    SpectrumInfo facts;
    bool open = false;
    HeadlessUi ui{[this] { open = draw_spectrum_panel(facts); }};
};

}  // namespace

TEST_CASE("the spectrum is folded at first and asks for nothing to be measured") {
    const ViewAnalysis analysis = some_analysis();
    SpectrumUi panel;
    panel.facts.analysis = &analysis;
    CHECK_FALSE(panel.open);
    CHECK_FALSE(panel.ui.has("Spectrum picture"));
    panel.ui.click("Spectrum");
    CHECK(panel.open);
    CHECK(panel.ui.has("Spectrum picture"));
    CHECK(panel.ui.has("Radial power"));
    CHECK(panel.ui.has("Periodicity"));
    CHECK(panel.ui.has("Nearest distances"));
    panel.ui.click("Spectrum");
    CHECK_FALSE(panel.open);
}

TEST_CASE("an open spectrum asks to be measured before there is anything to show") {
    SpectrumUi panel;
    panel.ui.click("Spectrum");
    CHECK(panel.open);
    CHECK_FALSE(panel.ui.has("Spectrum picture"));
}

TEST_CASE("a spectrum of no dots or of an error shows no plots") {
    ViewAnalysis analysis;
    SpectrumUi panel;
    panel.facts.analysis = &analysis;
    panel.ui.click("Spectrum");
    CHECK(panel.open);
    CHECK_FALSE(panel.ui.has("Spectrum picture"));
    analysis = some_analysis();
    analysis.error = "something is wrong";
    panel.ui.frame();
    CHECK_FALSE(panel.ui.has("Spectrum picture"));
}

TEST_CASE("spectrum plots lie below each other within the panel") {
    const ViewAnalysis analysis = some_analysis();
    SpectrumUi panel;
    panel.facts.analysis = &analysis;
    panel.ui.click("Spectrum");
    const WidgetPlace picture = panel.ui.place("Spectrum picture"), curve = panel.ui.place("Radial power");
    CHECK(picture.max.y <= curve.min.y);
    for (const WidgetPlace& place : {picture, curve}) {
        CHECK(place.min.x >= 0);
        CHECK(place.max.x <= 400);
        CHECK(place.max.y - place.min.y > 100);
    }
}

TEST_CASE("words for a periodicity go from none to exact") {
    CHECK(repetition_in_words(0) == std::string("no repetition"));
    CHECK(repetition_in_words(-0.03) == std::string("no repetition"));
    CHECK(repetition_in_words(0.6) == std::string("repeats strongly"));
    CHECK(repetition_in_words(1) == std::string("repeats itself exactly"));
}

TEST_CASE("the spectrum calls orange spots a repetition only beside a tile that repeats") {
    const auto claims_it = [](const std::optional<double>& periodicity) {
        const std::string words = spots_in_words(periodicity);
        return words.find("which repeats") != std::string::npos;
    };
    CHECK(claims_it(0.95));
    CHECK_FALSE(claims_it(0.02));
    CHECK_FALSE(claims_it(-0.01));
    CHECK_FALSE(claims_it(std::nullopt));
    // As its bar and its sentence do.
    for (double periodicity = 0; periodicity <= 1; periodicity += 0.01) {
        const std::string words = repetition_in_words(periodicity);
        CHECK(claims_it(periodicity) == (words == "repeats strongly" || words == "repeats itself exactly"));
    }
}

}  // namespace dapple
