#include <doctest/doctest.h>

#include <string>

#include "app/viewer/panels/window_panels.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

constexpr float kCanvasEnd = 700, kWidth = 940;

/// A film's bar below the canvas, and beside it a column of rows with long tips.
struct Player {
    PlayedFilm film;
    FilmKind chosen = FilmKind::growth;
    HeadlessUi ui{[this] {
        keep_tips_above(kCanvasEnd);
        ImGui::SetCursorScreenPos({kWidth + 20, kCanvasEnd + 10});
        wide_button("Watch the plot",
                    "Shows the pen's route and how long a machine takes. This is a sentence of several "
                    "lines, for a small column.");
        draw_player_bar(film, "30 dots", chosen, {0, kCanvasEnd}, {kWidth, player_bar_height()});
    }};

    Player() {
        ImGui::GetIO().DisplaySize = {1280, 800};
        ui.frame();
    }
    void rest_on(const std::string& widget) {
        ui.move_to(ui.at(widget, 0.5f));
        ui.frame(1);
        ui.frame();
        ui.frame();
    }
};

}  // namespace

TEST_CASE("no tip covers a film's bar, neither those of its own controls nor those of the rows beside it") {
    Player player;
    for (const char* const widget :
         {"Film", "Play film", "Moment", "Takes", "Save film...", "Close", "Watch the plot"}) {
        CAPTURE(widget);
        player.rest_on(widget);
        REQUIRE(player.ui.has("Tip"));
        const WidgetPlace tip = player.ui.place("Tip");
        CHECK(tip.max.y < kCanvasEnd);
        CHECK(tip.min.y > 0);
        CHECK(tip.min.x >= 0);
        CHECK(tip.max.x <= 1280);
    }
}

}  // namespace dapple
