// The window's state without the window: what has changed, is undone, saved and opened.

#include <doctest/doctest.h>

#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "app/viewer/model/history.h"
#include "app/viewer/model/session.h"
#include "core/tile/tile_file.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"
#include "tests/file_text.h"
#include "tests/split_session.h"
#include "tests/temporary_folder.h"

namespace dapple {

namespace fs = std::filesystem;

TEST_CASE("a change is told by the row that makes it") {
    const ViewerSettings before;
    const auto words = [&](auto change) {
        ViewerSettings after = before;
        change(after);
        return change_in_words(before, after);
    };
    CHECK(words([](ViewerSettings& s) { s.drawing.page.quarter_turns = 1; }) == "Rotate");
    CHECK(words([](ViewerSettings& s) { s.picture_opacity = 0.5f; }) == "Photo beneath");
    CHECK(words([](ViewerSettings& s) { s.drawing.page.paper = Paper::a4; }) == "Paper size");
    CHECK(words([](ViewerSettings& s) { s.drawing.paper = kBlack; }) == "Paper");
    CHECK(words([](ViewerSettings& s) { s.drawing.placing.count = 5; }) == "Dots");
    CHECK(words([](ViewerSettings& s) { s.drawing.tone.black_point = 0.1f; }) == "Black point");
    CHECK(words([](ViewerSettings& s) { s.drawing.page.margins = Margins{1, 1, 1, 1}; }) == "Margins");
    CHECK(words([](ViewerSettings& s) { s.drawing.pen_width_mm = 1; }) == "Pen width");
    CHECK(words([](ViewerSettings&) {}).empty());
}

TEST_CASE("a change of several pens is told by its own row") {
    ViewerSettings before;
    before.drawing.pens = parse_pens("Sky:#3aa0d8:0.3,Ochre:#805010:0.5,Ink:#101010:0.2");
    const auto words = [&](auto change) {
        ViewerSettings after = before;
        change(after.drawing.pens);
        return change_in_words(before, after);
    };
    CHECK(words([](PenChoice& pens) { pens.set = PenSet::cmyk; }) == "Inks");
    CHECK(words([](PenChoice& pens) { pens.own[1].name = "Sand"; }) == "Pen 2");
    CHECK(words([](PenChoice& pens) { pens.own[0].colour = kBlack; }) == "Colour 1");
    CHECK(words([](PenChoice& pens) { pens.own[2].width_mm = 0.4; }) == "Width 3");
    CHECK(words([](PenChoice& pens) { pens.own[2].gap_mm = 0.4; }) == "Gap 3");
    CHECK(words([](PenChoice& pens) { pens.own[2].gain_mm = 0.04; }) == "Gain 3");
    CHECK(words([](PenChoice& pens) { pens.own.push_back({.name = "Red"}); }) == "Add a pen");
    CHECK(words([](PenChoice& pens) { pens.own.erase(pens.own.begin() + 1); }) == "Remove Ochre");
    CHECK(words([](PenChoice& pens) { pens.own.pop_back(); }) == "Remove Ink");
    CHECK(words([](PenChoice& pens) { std::swap(pens.own[0], pens.own[1]); }) == "Draw Ochre earlier");
    CHECK(words([](PenChoice& pens) { pens.own = palette_of({.set = PenSet::cmyk}); }) == "Palette");
    before.drawing.pens = parse_pens("cmyk:0.3");
    CHECK(words([](PenChoice& pens) { pens.width_mm = 0.4; }) == "Tip width");
    CHECK(words([](PenChoice& pens) { pens.gain_mm = 0.04; }) == "Dot gain");
    CHECK(words([](PenChoice& pens) { pens.black = 0.8; }) == "Black in greys");
    before.drawing.pens = parse_pens("auto:4");
    CHECK(words([](PenChoice& pens) { pens.automatic = 5; }) == "How many");
    CHECK(words([](PenChoice& pens) { pens.own = palette_of({.set = PenSet::cmyk}), pens.automatic = 3; }) ==
          "Palette");
}

TEST_CASE("a drawing has changes until it is undone, or saved in what holds its settings") {
    const TemporaryFolder folder;
    Session session(DrawingSettings{}, [] {});
    session.settings.drawing.placing.count = 500;
    session.begin_with(session.settings);
    session.open_sample();
    const auto brings = [&](auto done) { return comes_to(session, done); };
    const auto change = [&](float brightness) {
        session.settings.drawing.tone.brightness = brightness;
        session.remember(false);
    };
    REQUIRE(brings([&] { return session.placed_once(); }));
    CHECK_FALSE(session.has_changes());
    change(0.1f);
    CHECK(session.has_changes());
    session.undo();
    CHECK_FALSE(session.has_changes());
    session.redo();
    CHECK(session.has_changes());
    for (const char* const name : {"a.csv", "a.svg"}) {
        session.save(folder / name);
        REQUIRE(brings([&] { return session.saved_path() == folder / name; }));
        CHECK(session.has_changes() == (std::string(name) == "a.csv"));
    }
    change(0.2f);
    CHECK(session.has_changes());
    CHECK(session.would_lose_changes("other.dapple"));
    CHECK_FALSE(session.would_lose_changes("other.png"));  // its settings go on
    session.save_project(folder / "a.dapple");
    CHECK_FALSE(session.has_changes());
    change(0.3f);
    CHECK(session.would_lose_changes("other.png"));
    CHECK_FALSE(session.would_lose_changes("other.tile"));

    session.keep(folder / "kept.dapple");
    CHECK(session.project_path() == folder / "a.dapple");
    CHECK(session.has_changes());
    session.open_project(folder / "a.dapple");
    REQUIRE(brings([&] { return session.pictures() == 2; }));
    CHECK_FALSE(session.has_changes());
    session.bring_back(folder / "kept.dapple");
    REQUIRE(brings([&] { return session.pictures() == 3; }));
    CHECK(session.settings.drawing.tone.brightness == 0.3f);
    CHECK(session.has_changes());
    CHECK(session.project_path().empty());
    session.open_sample();
    REQUIRE(brings([&] { return session.pictures() == 4; }));
    CHECK_FALSE(session.has_changes());

    // One whose picture cannot be read is not taken for unsaved, or what was kept would be given up with it.
    put_text(folder / "broken.png", "no picture");
    put_text(folder / "kept.dapple", R"({"dapple": 1, "picture": {"file": "broken.png"}})");
    session.bring_back(folder / "kept.dapple");
    CHECK_FALSE(session.has_changes());
    REQUIRE(brings([&] { return session.banner.kind == BannerKind::error; }));
    CHECK_FALSE(session.has_changes());
}

TEST_CASE("a dropped tile file is drawn with until undo brings the former tile back") {
    TemporaryFolder folder;
    // The dots of a built-in tile under another name.
    put_text(folder / "Mine.TILE", write_tile(load_tile("aperiodic64")));
    SplitSession split(2000);
    Session& session = split.session;
    session.settings.drawing.tile = "aperiodic64";
    session.remember(false);
    REQUIRE(split.brings([&] { return session.pane().tile().name == "aperiodic64"; }));
    const std::vector<glm::dvec2> expected = places_of(session.pane().page());
    session.settings.drawing.tile = kDefaultTile;
    session.remember(false);
    REQUIRE(split.brings([&] { return session.pane().tile().name == kDefaultTile; }));

    session.take_dropped(folder / "Mine.TILE");
    CHECK(session.banner.message.empty());
    const std::string name = session.settings.drawing.tile;
    CHECK(fs::equivalent(name, folder / "Mine.TILE"));
    session.remember(false);
    REQUIRE(split.brings([&] { return session.pane().tile().name == name; }));
    check_same(places_of(session.pane().page()), expected);
    CHECK(session.pictures() == 1);

    session.undo();
    CHECK(session.settings.drawing.tile == kDefaultTile);
    CHECK(split.brings([&] { return session.pane().tile().name == kDefaultTile; }));
    // It can be chosen again, and stands in the list once however often it is opened.
    session.open_tile(folder / "Mine.TILE");
    CHECK(std::ranges::count(session.tiles(), name) == 1);
}

TEST_CASE("a file that is not a tile is told of with the line that is wrong, and the tile stays") {
    TemporaryFolder folder;
    std::ofstream(folder / "broken.tile") << "dapple tile 1\nrule 9999\n";
    SplitSession split(2000);
    Session& session = split.session;
    const auto tiles = session.tiles().size();
    for (const char* file : {"broken.tile", "missing.tile"}) {
        CAPTURE(file);
        session.banner = {};
        session.take_dropped(folder / file);
        CHECK(session.banner.kind == BannerKind::error);
        std::string sentence;
        try {
            load_tile((folder / file).string());
        } catch (const std::exception& error) {
            sentence = error.what();
        }
        CHECK(session.banner.message == sentence);
        CHECK(session.banner.message.find(file) != std::string::npos);
        CHECK(session.settings.drawing.tile == kDefaultTile);
    }
    CHECK(session.tiles().size() == tiles);
}

TEST_CASE("what is said of a placing that failed goes with the next one that does not") {
    SplitSession split(500);
    split.session.settings.comparison.on = false;
    split.session.settings.drawing.tile = "no such tile";
    REQUIRE(split.brings([&] { return !split.session.banner.message.empty(); }));
    CHECK(split.session.banner.kind == BannerKind::error);
    split.session.settings.drawing.tile = "paper16";
    CHECK(split.brings([&] { return split.session.banner.message.empty(); }));
    CHECK(split.session.pane().tile().name == "paper16");
}

TEST_CASE("another picture is not saved over the one before") {
    TemporaryFolder folder;
    Session session(DrawingSettings{}, [] {});
    const auto brings = [&](auto done) { return comes_to(session, done); };
    session.open_sample();
    REQUIRE(brings([&] { return session.placed_once(); }));
    session.save(folder / "a.csv");
    REQUIRE(brings([&] { return session.saved_path() == folder / "a.csv"; }));
    // Nor does redo bring back what was undone of that.
    session.settings.drawing.placing.count = 321;
    session.remember(false);
    session.undo();
    session.remember(false);
    REQUIRE(session.redo_words());
    session.open_sample();
    REQUIRE(brings([&] { return session.pictures() == 2; }));
    CHECK(session.saved_path().empty());
    session.remember(false);
    CHECK_FALSE(session.redo_words());
    session.redo();
    CHECK(session.settings.drawing.placing.count != 321u);
}

TEST_CASE("a placing that takes too long can be given up: drawing and settings are as before") {
    Session session(DrawingSettings{}, [] {});
    session.settings.drawing.placing.count = 1000;
    session.settings.drawing.relax = 0;
    session.open_sample();
    const auto brings = [&](auto done) { return comes_to(session, done); };
    REQUIRE(brings([&] { return session.pane().page().dots.size() == 1000; }));
    session.settings.drawing.placing.count = 10'000'000;
    REQUIRE(brings([&] { return session.pane().worker().placing_since().has_value(); }));
    session.stop_placing();
    CHECK(session.settings.drawing.placing.count == 1000);
    CHECK(brings([&] {
        return session.pane().page().request == session.pane().page_requested() &&
               !session.pane().worker().placing_since();
    }));
    CHECK(session.pane().page().dots.size() == 1000);
}

TEST_CASE("a drawing that relaxes is kept with the steps that it has when its work is given up") {
    Session session(DrawingSettings{}, [] {});
    session.settings.drawing.placing.count = 200'000;
    session.settings.drawing.relax = 100;
    session.open_sample();
    const auto brings = [&](auto done) { return comes_to(session, done); };
    REQUIRE(brings([&] { return session.placed_once(); }));
    REQUIRE_FALSE(session.pane().page().settled());
    session.stop_placing();
    CHECK(session.settings.drawing.relax < 100);
    CHECK(session.settings.drawing.placing.count == 200'000);
    CHECK(
        brings([&] { return session.pane().page().settled() && !session.pane().worker().placing_since(); }));
    // The method shows dots where they were placed; the settings stay.
    session.settings.drawing.relax = 3;
    session.as_placed = true;
    CHECK(brings([&] { return session.pane().page().settled() && session.pane().page().plan.steps == 0; }));
    CHECK(session.settings.drawing.relax == 3);
}

TEST_CASE("what undo and redo would change is said in a word or two") {
    Session session({}, [] {});
    CHECK_FALSE(session.undo_words());
    session.settings.drawing.tone.contrast = 0.5f;
    session.remember(true);
    CHECK_FALSE(session.undo_words());
    session.remember(false);
    CHECK(session.undo_words() == "Contrast");
    session.settings.drawing.page.margins = Margins{.left = 20};
    session.settings.drawing.dot_size.sizing = DotSizing::fixed;
    session.settings.density.source = DensitySource::grey;
    session.remember(false);
    CHECK(session.undo_words() == "Dot size and 2 more");
    CHECK_FALSE(session.redo_words());
    session.undo();
    CHECK(session.undo_words() == "Contrast");
    CHECK(session.redo_words() == "Dot size and 2 more");
    session.undo();
    CHECK_FALSE(session.undo_words());
    CHECK(session.redo_words() == "Contrast");
}

TEST_CASE("each change has the name of its row") {
    Session session({}, [] {});
    ViewerSettings& settings = session.settings;
    const auto words_after = [&](const std::function<void()>& change) {
        change();
        session.remember(false);
        return session.undo_words().value_or("");
    };
    Comparison& right = settings.comparison;
    CHECK(words_after([&] { right = toggled(right, settings.drawing); }) == "Split view");
    CHECK(words_after([&] { right.placer = PlacerKind::figure8; }) == "Right placer");
    CHECK(words_after([&] { right.tile = "lattice24"; }) == "Right tile");
    CHECK(words_after([&] { right.by = CompareBy::count; }) == "Right side has");
    CHECK(words_after([&] { settings.loupe.step = 2; }) == "Its tiles");
    CHECK(words_after([&] { settings.loupe.on = true; }) == "Loupe");
    CHECK(words_after([&] { settings.density.grey = 0.3f; }) == "Grey");
    CHECK(words_after([&] { settings.density.source = DensitySource::ramp; }) == "Density");
    DrawingSettings& drawing = settings.drawing;
    CHECK(words_after([&] { drawing.dot_size.sizing = DotSizing::by_tone; }) == "Dot size");
    CHECK(words_after([&] { drawing.dot_size.largest_mm = 2; }) == "Largest");
    CHECK(words_after([&] { drawing.page.margins = Margins{10, 10, 10, 10}; }) == "Margins");
    CHECK(words_after([&] { drawing.page.margins->left = 20; }) == "Left");
    CHECK(words_after([&] { drawing.page.margins.reset(); }) == "Margins");
    CHECK(words_after([&] {
              drawing.page.crop = Crop{{{10, 10}, {90, 90}}, Crop::Unit::percent};
          }) == "Crop");
    CHECK(words_after([&] { drawing.page.crop->box.low.x = 20; }) == "From left");
    CHECK(words_after([&] { drawing.page.crop.reset(); }) == "Crop");
    CHECK(words_after([&] { settings.saving.gcode_template = {"dot {x}", "a.txt"}; }) == "Template");
}

TEST_CASE(
    "the crop's frame is around all of the picture on a page that it fills, whichever way it is turned") {
    Session session(DrawingSettings{}, [] {});
    PageSetup& setup = session.settings.drawing.page;
    setup.paper = Paper::custom;
    setup.width_mm = 100;
    setup.height_mm = 300;
    setup.fit = PageFit::fill;
    setup.quarter_turns = 1;
    session.settings.drawing.placing.count = 100;
    session.open_sample();
    const auto framing_is = [&](auto&& right) {
        return comes_to(session,
                        [&] { return session.placed_once() && right(session.pane().page().plan.framing); });
    };
    const auto is_whole = [&](const Framing& framing) {
        return framing.pixels == Rectangle<int>{{0, 0}, session.pane().page().plan.opened};
    };
    REQUIRE(framing_is([&](const Framing& framing) { return !is_whole(framing); }));
    session.cropping.on = true;
    CHECK(
        framing_is([&](const Framing& framing) { return is_whole(framing) && framing.quarter_turns == 1; }));
    session.cropping.on = false;
    CHECK(framing_is([&](const Framing& framing) { return !is_whole(framing); }));
}

TEST_CASE(
    "a dark .hdr is drawn as the same light would be that is 4096 times brighter, and its exposure moves") {
    const TemporaryFolder folder;
    const auto dots = [&](int exponent, std::optional<float> stops, float& drawn_with) {
        const fs::path file = folder / "light.hdr";
        std::ofstream out(file, std::ios::binary);
        out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 16\n";
        // Light from 2^(exponent - 136) on, in a ramp of seven stops.
        for (int pixel = 0; pixel < 256; ++pixel)
            out << "\x90\x90\x90" << static_cast<char>(exponent + pixel / 37);
        out.close();
        Session session(DrawingSettings{}, [] {});
        session.settings.drawing.placing = {.scale = 100};
        session.settings.drawing.relax = 0;
        if (stops) {
            session.settings.drawing.automatic_exposure = false;
            session.settings.drawing.tone.exposure = *stops;
        }
        session.open(file);
        REQUIRE(comes_to(session, [&] { return session.placed_once() && !session.picture().file.empty(); }));
        drawn_with = session.pane().page().plan.tone.exposure;
        return session.pane().page().dots.size();
    };
    float dark = 0, bright = 0, moved = 0;
    const std::size_t of_dark = dots(112, {}, dark), of_bright = dots(124, {}, bright);
    CHECK(dark > 5);
    CHECK(dark - bright == doctest::Approx(12).epsilon(0.001));
    CHECK(of_dark == of_bright);
    CHECK(of_dark > 100);
    // What the issue was: without exposure such light is black.
    CHECK(dots(112, 0.0f, moved) > of_dark * 5 / 4);
    CHECK(moved == 0);
    CHECK(dots(112, dark + 3, moved) < of_dark * 4 / 5);
}

}  // namespace dapple
