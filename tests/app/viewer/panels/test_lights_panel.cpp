#include <doctest/doctest.h>

#include "app/viewer/panels/window_panels.h"
#include "tests/headless_ui.h"

using namespace dapple;

TEST_CASE("the lights panel that nobody touches changes nothing") {
    LightsSettings settings;
    settings.request.count = 777;
    const LightsSettings before = settings;
    bool changed = false;
    HeadlessUi ui([&] { changed |= draw_lights_panel(settings, LightsInfo{}, {}); });
    for (int i = 0; i < 5; ++i) ui.frame();
    CHECK_FALSE(changed);
    CHECK(settings == before);
}

TEST_CASE("figures that are not there yet are no numbers") {
    LightsSettings settings;
    std::optional<LightsInfo> facts;
    HeadlessUi ui([&] { draw_lights_panel(settings, facts, {}); });
    const auto glyphs = [] { return ImGui::GetDrawData()->TotalIdxCount; };
    const float measuring = ui.place("Placing").max.x - ui.place("Placing").min.x;
    const int before = glyphs();
    CHECK(measuring > ImGui::CalcTextSize("measurin").x);
    facts.emplace();
    ui.frame();
    CHECK(glyphs() != before);
    CHECK(ui.place("Placing").max.x - ui.place("Placing").min.x < measuring);
}

TEST_CASE("dragging the lights panel's sliders turns the map and sets exposure and count") {
    LightsSettings settings;
    HeadlessUi ui([&] { draw_lights_panel(settings, LightsInfo{}, {}); });
    ui.drag("Rotation", 0.5f, 1.0f);
    CHECK(settings.turn_degrees == 180);
    ui.drag("Exposure", 0.5f, 0.0f);
    CHECK(settings.stops == -12);
    ui.drag("Samples", 0.7f, 1.0f);
    CHECK(settings.request.count == 16'384);
    ui.drag("Seed", 0.0f, 1.0f);
    CHECK(settings.request.seed == 100);
}
