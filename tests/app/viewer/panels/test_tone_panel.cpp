// What the tone's rows do. Clicked and dragged without a window.

#include <doctest/doctest.h>

#include <functional>
#include <glm/glm.hpp>
#include <utility>

#include "app/viewer/panels/settings_panels.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

DrawingSettings in_own_tone(const Tone& tone) {
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.tone = tone;
    return settings;
}

/// With all of its rows in sight.
struct ToneUi : HeadlessUi {
    explicit ToneUi(std::function<void()> draw) : HeadlessUi(std::move(draw)) { click("More tone settings"); }
};

}  // namespace

TEST_CASE("a panel that nobody touches changes nothing") {
    DrawingSettings settings = in_own_tone({.contrast = 0.3f, .blur = 50});
    const Tone& tone = settings.tone;
    bool changed = false;
    ToneUi ui([&] { changed |= draw_tone_panel(settings, {}); });
    ui.move_to({200, 120});
    for (int i = 0; i < 5; ++i) ui.frame();
    CHECK_FALSE(changed);
    CHECK(tone == Tone{.contrast = 0.3f, .blur = 50});
}

TEST_CASE("dragging a tone slider to its ends gives its range") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    ToneUi ui([&] { draw_tone_panel(settings, {}); });
    ui.drag("Contrast", 0.5f, 1.0f);
    CHECK(tone.contrast == 1);
    ui.drag("Contrast", 1.0f, 0.0f);
    CHECK(tone.contrast == -1);
    ui.drag("Gamma", 0.5f, 1.0f);
    CHECK(tone.gamma == 4);
    ui.drag("Blur", 0.0f, 0.5f);
    CHECK(tone.blur == doctest::Approx(10).epsilon(0.02));
    CHECK(tone.brightness == 0);
}

TEST_CASE("one slider goes from true light to automatic tone, and leaves a tone of one's own") {
    DrawingSettings settings;
    ToneUi ui([&] { draw_tone_panel(settings, {}); });
    ui.drag("Auto tone", 0.6f, 1.0f);
    CHECK(settings.automatic_tone);
    CHECK(settings.tone_strength == 1);
    ui.double_click("Auto tone name");
    CHECK(settings == DrawingSettings{});
    ui.drag("Auto tone", 0.6f, 0.0f);
    CHECK_FALSE(settings.automatic_tone);
    CHECK(settings.tone == Tone{});
    ui.enter("Auto tone", "0.3");
    CHECK(settings.automatic_tone);
    CHECK(settings.tone_strength == 0.3);
    CHECK(settings.tone == DrawingSettings{}.tone);
    ui.enter("Gamma", "2");
    CHECK_FALSE(settings.automatic_tone);
    ui.enter("Auto tone", "0");
    CHECK_FALSE(settings.automatic_tone);
    CHECK(settings.tone == Tone{});
}

TEST_CASE("exposure is the picture's own until it is moved, and again once it is put back") {
    DrawingSettings settings;
    ToneInfo facts{.usual_exposure = -3.2f};
    bool changed = false;
    ToneUi ui([&] { changed |= draw_tone_panel(settings, facts); });
    CHECK_FALSE(changed);
    const float below = ui.place("Black point").min.y;
    ui.enter("Exposure", "1.5");
    CHECK_FALSE(settings.automatic_exposure);
    CHECK(settings.tone.exposure == 1.5f);
    CHECK(settings.automatic_tone);  // black, white and gamma still follow
    ui.enter("Auto tone", "0");
    CHECK(settings.tone.exposure == 1.5f);
    ui.enter("Exposure", "-3.2");
    CHECK(settings.automatic_exposure);

    ui.enter("Exposure", "2");
    ui.double_click("Exposure name");
    CHECK(settings.automatic_exposure);
    facts.usual_exposure = 0;
    ui.frame();
    ui.frame();
    CHECK(ui.place("Black point").min.y == below);  // no row moves meanwhile
}

TEST_CASE("a slider goes on following a mouse that leaves its row") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    ToneUi ui([&] { draw_tone_panel(settings, {}); });
    ui.move_to(ui.at("Brightness", 0.5f));
    ui.press();
    ui.move_to(ui.at("Brightness", 0.9f) + glm::vec2(0, 300));
    CHECK(tone.brightness > 0.7f);
    ui.release();
    ui.move_to(ui.at("Brightness", 0.1f));
    CHECK(tone.brightness > 0.7f);
}

TEST_CASE("black and white point push each other and never meet") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    ToneUi ui([&] { draw_tone_panel(settings, {}); });
    ui.drag("Black point", 0.0f, 1.0f);
    CHECK(tone.black_point < tone.white_point);
    ui.drag("White point", 1.0f, 0.0f);
    CHECK(tone.black_point < tone.white_point);
    CHECK(tone.black_point >= 0);
    CHECK(tone.white_point < 0.1f);
}

TEST_CASE("a double-click on a slider's name brings the neutral value back") {
    DrawingSettings settings = in_own_tone({.gamma = 3});
    const Tone& tone = settings.tone;
    ToneUi ui([&] { draw_tone_panel(settings, {}); });
    ui.double_click("Gamma name");
    CHECK(tone.gamma == 1);
}

TEST_CASE("Ctrl+click on a slider takes a typed number, beyond the track where that is allowed") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    ToneUi ui([&] { draw_tone_panel(settings, {}); });
    ui.enter("Blur", "250");
    CHECK(tone.blur == 100);
}

TEST_CASE("the invert switch toggles") {
    DrawingSettings settings = in_own_tone({});
    const Tone& tone = settings.tone;
    ToneUi ui([&] { draw_tone_panel(settings, {}); });
    ui.click("Invert");
    CHECK(tone.invert);
    ui.click("Invert");
    CHECK_FALSE(tone.invert);
}

TEST_CASE("a slider moved under the automatic tone goes on from what is drawn") {
    DrawingSettings settings;
    const Tone drawn{.black_point = 0.1f, .white_point = 0.8f, .gamma = 2, .detail = 0.5f};
    ToneUi ui([&] { draw_tone_panel(settings, {.drawn = drawn}); });
    ui.frame();
    CHECK(settings.automatic_tone);
    ui.drag("Brightness", 0.5f, 1.0f);
    CHECK_FALSE(settings.automatic_tone);
    CHECK(settings.tone.brightness == 1);
    CHECK(settings.tone.gamma == 2);
    CHECK(settings.tone.white_point == 0.8f);
    ui.double_click("Auto tone name");
    CHECK(settings.tone == DrawingSettings{}.tone);
    CHECK(settings.automatic_tone);
}

TEST_CASE(
    "a double-click under a tone of one's own brings what automatic tone chose, and all of it makes it "
    "auto") {
    DrawingSettings settings;
    const Tone chosen{.black_point = 0.1f, .white_point = 0.8f, .gamma = 2, .detail = 0.5f, .black = 0.95};
    ToneUi ui([&] { draw_tone_panel(settings, {.drawn = chosen, .usual = chosen}); });
    ui.double_click("Gamma name");  // which has moved nothing
    CHECK(settings.automatic_tone);
    ui.drag("Gamma", 0.5f, 0.0f);
    ui.enter("Black point", "0.3");
    ui.enter("Deepest black", "0.6");
    CHECK_FALSE(settings.automatic_tone);
    ui.double_click("Gamma name");
    CHECK(settings.tone.gamma == 2);
    ui.double_click("Deepest black name");
    CHECK(settings.tone.black == 0.95);
    CHECK_FALSE(settings.automatic_tone);
    ui.double_click("Black point name");
    const DrawingSettings fresh;
    CHECK(settings.automatic_tone);
    CHECK(settings.tone == fresh.tone);
}

TEST_CASE("black is as solid as the dots allow until its row is moved, and again once that is put back") {
    DrawingSettings settings;
    ToneInfo facts{.usual = {.black = 0.95}};
    ToneUi ui([&] { draw_tone_panel(settings, facts); });
    ui.enter("Deepest black", "0.7");
    CHECK(settings.tone.black == 0.7);
    CHECK(settings.automatic_tone);  // the other tones still follow
    ui.enter("Deepest black", "0.95");
    CHECK_FALSE(settings.tone.black);
    ui.enter("Deepest black", "1");
    CHECK(settings.tone.black == 1);
    settings.style = DrawingStyle::line;
    ui.frame();
    CHECK_FALSE(ui.has("Deepest black"));
}

TEST_CASE("a picture's arrival and a tone that is moved leave every row of the picture where it is") {
    DrawingSettings settings;
    ToneInfo info;
    ToneUi ui([&] {
        draw_tone_panel(settings, info);
        wide_button("Below", "");
    });
    const WidgetPlaces before = ui.places();
    info.histogram.counts[300] = info.histogram.total = 1000;
    info.usual_exposure = 5;
    for (int i = 0; i < 2; ++i) ui.frame();
    for (const char* row : {"Exposure", "Black point", "Gamma", "Invert", "Below"})
        CHECK(ui.place(row) == before.at(row));
}

TEST_CASE("how much of the photograph shows under the dots is a percentage") {
    DrawingSettings settings;
    float opacity = 0;
    ToneUi ui([&] { draw_tone_panel(settings, {.photograph = &opacity}); });
    ui.enter("Photo beneath", "30");
    CHECK(opacity == 0.3f);
    ui.enter("Photo beneath", "300");
    CHECK(opacity == 1);
}

}  // namespace dapple
