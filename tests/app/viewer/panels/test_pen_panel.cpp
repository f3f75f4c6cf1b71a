// What the rows of pens do. Clicked and dragged without a window.

#include <doctest/doctest.h>

#include <glm/glm.hpp>
#include <string>

#include "app/viewer/panels/settings_panels.h"
#include "tests/file_text.h"
#include "tests/headless_ui.h"

namespace dapple {

TEST_CASE("a pen's ink is picked") {
    DrawingSettings settings;
    HeadlessUi ui([&] { draw_pen_panel(settings); });
    glm::vec3 before = settings.ink;
    ui.click("Ink");
    // The picker opens beside the pointer; its square of shades is under it, a bit to the right and down.
    ui.frame();
    CHECK(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
    CHECK(settings.ink == before);
}

TEST_CASE("pens of one's own begin with those that drew, and are added, named and removed down to one") {
    DrawingSettings settings;
    settings.ink = glm::vec3(0.5f, 0, 0);
    HeadlessUi ui([&] { draw_pen_panel(settings); });
    const auto choose = [&](const char* set) {
        ui.click("Inks");
        ui.click(set);
    };
    Palette& own = settings.pens.own;
    choose("custom pens");
    ui.click("More pen settings");
    REQUIRE(own.size() == 1);
    CHECK(own[0].colour == settings.ink);
    CHECK_FALSE(ui.has("Remove Ink"));  // one draws
    own.clear();
    choose("greys");
    choose("custom pens");
    REQUIRE(own.size() == 3);
    ui.click("Add a pen");
    REQUIRE(own.size() == 4);
    CHECK(own[3].name != own[2].name);
    ui.click("Remove Grey");
    REQUIRE(own.size() == 3);
    CHECK(own[1].name == "Black");

    ui.click("Pen 2");
    ui.key(Key::end);
    ui.type("er");
    CHECK(own[1].name == "Blacker");
    ui.type(":");  // would end the name in a file
    CHECK(own[1].name == "Blacker");
    CHECK(ui.has("Refusal"));
    ui.key(Key::escape);
    own[1].name = "Twi";
    ui.frame();
    ui.click("Pen 2");
    ui.key(Key::end);
    own[0].name = "Twin";
    ui.type("n");  // another pen's
    CHECK(own[1].name == "Twi");
    ui.key(Key::escape);
    ui.enter("Width 3, mm", "0.5");
    CHECK(own[2].width_mm == 0.5);
    for (int i = 0; i < 20 && ui.has("Add a pen"); ++i) ui.click("Add a pen");
    CHECK(own.size() == kMostPens);
    CHECK(parse_pens(text_of(settings.pens)).own.size() == kMostPens);  // a project has them all
}

TEST_CASE("several pens are chosen with their width, and then draw registration marks if asked to") {
    DrawingSettings drawing;
    HeadlessUi ui([&] { draw_pen_panel(drawing); });
    CHECK_FALSE(ui.has("More pen settings"));
    ui.click("Inks");
    ui.click("CMYK");
    ui.click("More pen settings");
    CHECK(drawing.pens.set == PenSet::cmyk);
    ui.enter("Tip width, mm", "0.4");
    CHECK(drawing.pens.width_mm == 0.4);
    ui.enter("Dot gain, mm", "0.04");
    CHECK(drawing.pens.gain_mm == 0.04);
    ui.enter("Black in greys", "0.9");
    CHECK(drawing.pens.black == 0.9);
    ui.click("Registration");
    CHECK(drawing.registration);
    ui.click("Inks");
    ui.click("custom pens");
    REQUIRE(drawing.pens.own.size() == 4);
    CHECK(drawing.pens.own[0].width_mm == 0.4);
    ui.enter("Width 1, mm", "0.7");
    CHECK(drawing.pens.own[0].width_mm == 0.7);
    ui.enter("Gap 1, mm", "1.5");
    CHECK(drawing.pens.own[0].gap_mm == 1.5);
    CHECK(drawing.pens.own[0].gain_mm == 0.04);
    ui.enter("Gain 1, mm", "0.06");
    CHECK(drawing.pens.own[0].gain_mm == 0.06);
}

TEST_CASE("own pens draw in the order in which they are listed, and change places there") {
    DrawingSettings drawing;
    drawing.pens = parse_pens("Night:#102060,Sand:#d0a040,White:#ffffff");
    HeadlessUi ui([&] { draw_pen_panel(drawing, LengthUnit::mm, {}); });
    ImGui::GetIO().DisplaySize.y = 1200;  // all of three pens are in sight
    ui.click("More pen settings");
    const auto names = [&] {
        std::string all;
        for (const Pen& pen : drawing.pens.own) all += pen.name + " ";
        return all;
    };
    CHECK_FALSE(ui.has("Draw Sand earlier"));  // the lightest are first
    ui.click("Pen order");
    ui.click("as listed");
    CHECK(drawing.pens.order == PenOrder::listed);
    CHECK_FALSE(ui.has("Draw Night earlier"));  // it is the first
    ui.click("Draw White earlier");
    CHECK(names() == "Night White Sand ");
    ui.click("Remove White");
    CHECK(names() == "Night Sand ");
}

TEST_CASE("a pen is hidden, or looked at alone, and the settings stay as they are") {
    DrawingSettings drawing;
    drawing.pens.set = PenSet::cmyk;
    const DrawingSettings before = drawing;
    Palette pens = palette_of(drawing.pens);
    ShownPens shown;
    HeadlessUi ui([&] { draw_pen_panel(drawing, LengthUnit::mm, {pens, {}, &shown}); });
    ui.click("More pen settings");
    CHECK(hidden_among(pens, shown) == 0);
    ui.click("Show Magenta");
    CHECK(hidden_among(pens, shown) == 0b0010);
    // By its name: it stays hidden where the pens come in another order.
    sort_pens(pens, PenOrder::lightest);
    REQUIRE(pens[2].name == "Magenta");
    CHECK(hidden_among(pens, shown) == 0b0100);
    ui.click("Pens shown");
    ui.click("1 Yellow alone");
    CHECK(hidden_among(pens, shown) == 0b1110);
    pens.erase(pens.begin());  // without it, there are all again that are not hidden
    ui.frame();
    CHECK(hidden_among(pens, shown) == 0b010);
    ui.click("Show Magenta");
    CHECK(hidden_among(pens, shown) == 0);
    // An eye that is opened or shut ends the look at one alone.
    ui.click("Pens shown");
    ui.click("2 Cyan alone");  // the rows are the settings', whatever was placed last
    ui.click("Show Black");
    CHECK(hidden_among(pens, shown) == 0);
    CHECK(drawing == before);
}

TEST_CASE("white ink on black paper is a choice, offered where nearly all dots would go into black") {
    DrawingSettings settings;
    bool mostly_black = false;
    HeadlessUi ui([&] { draw_pen_panel(settings, LengthUnit::mm, {}, {}, mostly_black); });
    const auto choose = [&](const char* inks) {
        ui.click("Inks");
        ui.click(inks);
    };
    const auto is_white_on_black = [&] {
        return settings.tone.invert && settings.ink == kWhite && settings.paper == kBlack;
    };
    choose("white on black");
    CHECK(is_white_on_black());
    choose("CMYK");
    CHECK(settings.pens.set == PenSet::cmyk);
    CHECK_FALSE(settings.tone.invert);
    CHECK(settings.paper == kWhite);
    choose("one ink");
    CHECK(settings == DrawingSettings{});
    CHECK_FALSE(ui.has("White ink on black paper"));
    mostly_black = true;
    ui.frame();
    ui.click("White ink on black paper");
    CHECK(is_white_on_black());
}

}  // namespace dapple
