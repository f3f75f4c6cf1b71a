// Banners and the status line. Clicked and dragged without a window.

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <string>

#include "app/viewer/panels/window_panels.h"
#include "tests/headless_ui.h"

namespace dapple {

TEST_CASE("the banner stays until its cross is clicked") {
    Banner banner{BannerKind::error, "cat.png: not a picture"};
    HeadlessUi ui([&] { draw_banner(banner, {0, 0}, {400, 300}); });
    for (int i = 0; i < 10; ++i) ui.frame();
    CHECK(banner.message == "cat.png: not a picture");
    ui.click("Close message");
    CHECK(banner.message.empty());
}

TEST_CASE("a notice goes by itself after some seconds, an error does not") {
    Banner notice{BannerKind::notice, "Saved cat.svg"};
    HeadlessUi ui([&] { draw_banner(notice, {0, 0}, {400, 300}); });
    ui.frame(1);
    ui.frame(1);
    CHECK(notice.message == "Saved cat.svg");
    // The window that sleeps wakes when it begins to fade.
    CHECK(seconds_until_change(notice) > 1);
    CHECK(seconds_until_change(notice) < 10);
    for (int second = 0; second < 10; ++second) ui.frame(1);
    CHECK(notice.message.empty());
    notice = {BannerKind::error, "cat.png: not a picture"};
    CHECK(seconds_until_change(notice) > 1e9);
    for (int second = 0; second < 20; ++second) ui.frame(1);
    CHECK(notice.message == "cat.png: not a picture");
    // The way to a saved file goes with its notice; what else is offered stays.
    notice = {.message = "Saved cat.svg", .offer = kShowInFolder};
    for (int second = 0; second < 20; ++second) ui.frame(1);
    CHECK(notice.message.empty());
    notice = {.message = "cat.hdr looks like an environment map.", .offer = "Open as lights"};
    for (int second = 0; second < 20; ++second) ui.frame(1);
    CHECK_FALSE(notice.message.empty());
}

TEST_CASE("a notice stays while the mouse is on it, and a new one starts anew however long nobody drew") {
    Banner banner{BannerKind::notice, "Saved cat.svg"};
    HeadlessUi ui([&] { draw_banner(banner, {0, 0}, {400, 300}); });
    const glm::vec2 on_it = ui.at("Close message", 0) - glm::vec2(20, 0);
    ui.move_to(on_it);
    for (int second = 0; second < 20; ++second) ui.frame(1);
    CHECK(banner.message == "Saved cat.svg");
    ui.move_to({1, 899});
    banner = {BannerKind::notice, "Saved dog.svg"};
    ui.frame(60);
    CHECK(banner.message == "Saved dog.svg");
}

TEST_CASE("saving can be cancelled by its button, and by nothing else") {
    int cancelled = 0;
    HeadlessUi ui([&] {
        cancelled += draw_saving_banner("a long name of a file.svg", 0.4, {0, 0}, {400, 300});
    });
    ui.move_to({100, 270});
    ui.press();
    ui.release();
    CHECK(cancelled == 0);
    ui.click("Cancel saving");
    CHECK(cancelled == 1);
}

TEST_CASE("the status line says dots as people write them, and Figure 8's duplicates") {
    CHECK(dots_in_words({.dots = 1'234'567}) == "1,234,567 dots");
    CHECK(dots_in_words({.dots = 1}) == "1 dot");
    CHECK(dots_in_words({.dots = 54'608, .duplicates = 13'648, .figure8 = true}) ==
          "54,608 dots, 13,648 of them duplicates (25 %)");
    CHECK(dots_in_words({.figure8 = true}) == "0 dots, 0 of them duplicates (0 %)");
}

TEST_CASE("the status line says that a placing takes long, and how long the last one took otherwise") {
    const auto says = [](double seconds, const std::string& words) {
        const auto items =
            status_items({.dots = 5, .place_ms = 12.34, .placing_seconds = seconds, .method = true});
        return std::ranges::any_of(items, [&](const StatusItem& item) { return item.text == words; });
    };
    CHECK(says(0, "placing 12.3 ms"));
    CHECK(says(0.2, "placing 12.3 ms"));
    CHECK(says(0.8, "Placing 1 s (Esc stops)"));
    CHECK_FALSE(says(0.8, "placing 12.3 ms"));
}

TEST_CASE("a placing that takes long shows its share, in words and as a bar, and so does what settles") {
    StatusInfo facts{.placing_seconds = 0.4, .placed_share = 0.25};
    HeadlessUi ui([&] { draw_status_line({0, 500}, {400, 30}, facts); });
    const auto says = [&](const std::string& words) {
        return std::ranges::any_of(status_items(facts),
                                   [&](const StatusItem& item) { return item.text == words; });
    };
    CHECK_FALSE(ui.has("Progress"));  // not long yet
    facts.placing_seconds = 0.6;
    ui.frame();
    CHECK(says("Placing 25 % (Esc stops)"));
    CHECK(ui.place("Progress").max.x == 100);
    facts.steps = 3;
    facts.all_steps = 4;
    ui.frame();
    CHECK(says("Relaxing 3 of 4 (Esc stops)"));
    CHECK(ui.place("Progress").max.x == 300);
    facts = {.placing_seconds = 0.6};  // Figure 8's come at once
    ui.frame();
    CHECK_FALSE(ui.has("Progress"));
    CHECK(says("Placing 1 s (Esc stops)"));
}

TEST_CASE("the status line tells dots, paper and zoom; scale and times only where the method is looked at") {
    StatusInfo facts{.dots = 40'000, .scale = 2500, .tone_ms = 1, .place_ms = 3, .draw_ms = 2, .zoom = 0.68};
    const auto words = [&] {
        std::string all;
        for (const StatusItem& item : status_items(facts)) all += item.text + "; ";
        return all;
    };
    CHECK(words() == "40,000 dots; 68 %; ");
    facts.as_dense_as = 2.56e6;
    CHECK(words() == "40,000 dots, here as dense as 2.56 million; 68 %; ");
    facts.as_dense_as = 0;
    facts.paper = paper_in_words({210, 297, 297}, LengthUnit::mm);
    CHECK(words() == "40,000 dots; 210 x 297 mm; 68 %; ");
    CHECK(paper_in_words({215.9, 279.4, 279.4}, LengthUnit::inch) == "8.5 x 11 in");
    facts.paper.clear();
    facts.method = true;
    CHECK(words().starts_with("40,000 dots; 68 %; scale 2,500; tone 1.0 ms; "));
    CHECK(words().find("drawing 2.0 ms") != std::string::npos);
}

TEST_CASE("a narrow status line keeps the number of dots and lets the rest go, the least important first") {
    const StatusInfo facts{
        .dots = 40'000, .scale = 2500, .tone_ms = 1, .frames_per_second = 60, .method = true};
    HeadlessUi ui([] {});
    std::size_t before = 0;
    for (const float width : {10.0f, 250.0f, 400.0f, 2000.0f}) {
        const auto items = fitting(status_items(facts), width);
        CHECK(items.size() > before);
        before = items.size();
        CHECK(items.front().text == "40,000 dots");
        float needed = 0;
        for (const StatusItem& item : items) needed += ImGui::CalcTextSize(item.text.c_str()).x;
        if (items.size() > 1) CHECK(needed < width);
    }
    CHECK(before == status_items(facts).size());
    const auto two = fitting(status_items(facts), 200);
    REQUIRE(two.size() == 2);
    CHECK(two.back().text == "100 %");
}

}  // namespace dapple
