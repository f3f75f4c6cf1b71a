// The section "In space", without a window.

#include <doctest/doctest.h>

#include "app/viewer/panels/space_panel.h"
#include "tests/headless_ui.h"

namespace dapple {

TEST_CASE("the section is folded at first, so that no dots are placed in space; its rows choose which are") {
    SpaceSettings settings;
    bool open = true;
    HeadlessUi ui([&] { open = draw_space_panel(settings); });
    CHECK_FALSE(open);
    CHECK_FALSE(ui.has("Volume"));
    ui.click("In space");
    CHECK(open);
    ui.click("ball");
    CHECK(settings.choice.volume == SpaceVolume::ball);
    ui.click("Settled");
    CHECK_FALSE(settings.choice.settled);
    ui.enter("Dots there", "123");
    CHECK(settings.choice.dots == 123);
    ui.enter("Dots there", "1e9");
    CHECK(settings.choice.dots == 123);
    CHECK(ui.has("Refusal"));
    ui.enter("Turned by", "90");
    CHECK(settings.turn == doctest::Approx(0.25));
    ui.click("Turning");
    CHECK_FALSE(settings.turning);
}

}  // namespace dapple
