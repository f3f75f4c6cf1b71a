// Undo and redo over the opening of pictures and projects.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "app/viewer/model/session.h"
#include "tests/file_text.h"
#include "tests/split_session.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

/// One picture is shown, another and a project of a third are there.
struct Openings {
    TemporaryFolder folder;
    Session session{DrawingSettings{}, [] {}};

    Openings() {
        for (const char* const name : {"one.pgm", "two.pgm", "three.pgm"})
            put_text(folder / name, "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
        put_text(folder / "p.dapple",
                 R"({"dapple": 1, "picture": "three.pgm", "drawing": {"count": 77, "relax": 0}})");
        session.settings.drawing.placing.count = 100;
        session.settings.drawing.relax = 0;
        session.begin_with(session.settings);
        session.open(folder / "one.pgm");
        REQUIRE(shows("one.pgm"));
    }

    template <class Done>
    bool brings(Done done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.remember(false);
            session.request_dots({.camera = fitted(kCanvas, {1, 1})});
            return done();
        });
    }
    bool shows(const std::string& name) {
        return brings([&] { return session.placed_once() && session.picture().file == folder / name; });
    }
    void change_brightness(float brightness) {
        session.settings.drawing.tone.brightness = brightness;
        session.remember(false);
    }
    void paint_mask() {
        session.settings.drawing.mask = Mask(Grid<std::uint8_t>(2, 2, 7));
        session.settings.drawing.edits = "dot 1,2;";
        session.remember(false);
    }
    float brightness() const { return session.settings.drawing.tone.brightness; }
};

}  // namespace

TEST_CASE("the opening of a picture is undone and done again, each picture with its own settings") {
    Openings all;
    Session& session = all.session;
    CHECK_FALSE(session.undo_words());  // there is nothing before the first
    all.change_brightness(0.1f);
    all.paint_mask();
    const ViewerSettings of_one = session.settings;
    session.open(all.folder / "two.pgm");
    REQUIRE(all.shows("two.pgm"));
    CHECK(session.settings.drawing.mask.empty());
    CHECK(session.settings.drawing.edits.empty());
    CHECK(session.undo_words() == "opening two.pgm");
    all.change_brightness(0.2f);
    CHECK(session.undo_words() == "Brightness");

    session.undo();
    CHECK(all.brightness() == 0.1f);
    CHECK(session.picture().file == all.folder / "two.pgm");
    CHECK(session.settings.drawing.mask.empty());
    session.undo();
    REQUIRE(all.shows("one.pgm"));
    CHECK(session.settings == of_one);
    CHECK(session.picture_path() == all.folder / "one.pgm");
    CHECK(session.undo_words() == "Mask and 1 more");
    CHECK(session.redo_words() == "opening two.pgm");
    session.undo();
    CHECK(session.settings.drawing.mask.empty());
    CHECK(session.picture().file == all.folder / "one.pgm");

    session.redo();
    session.redo();
    REQUIRE(all.shows("two.pgm"));
    CHECK(all.brightness() == 0.1f);
    CHECK(session.settings.drawing.mask.empty());
    session.redo();
    CHECK(all.brightness() == 0.2f);
    CHECK_FALSE(session.redo_words());
}

TEST_CASE("what was undone of a picture does not come back on another") {
    Openings all;
    Session& session = all.session;
    all.paint_mask();
    session.undo();
    REQUIRE(session.redo_words() == "Mask and 1 more");
    session.open(all.folder / "two.pgm");
    REQUIRE(all.shows("two.pgm"));
    CHECK_FALSE(session.redo_words());
    session.redo();
    CHECK(session.settings.drawing.mask.empty());
}

TEST_CASE("a project's opening is undone, and done again it is that project, saved or not") {
    Openings all;
    Session& session = all.session;
    all.change_brightness(0.1f);
    session.take_dropped(all.folder / "p.dapple");
    REQUIRE(all.shows("three.pgm"));
    CHECK(session.undo_words() == "opening p.dapple");
    CHECK_FALSE(session.has_changes());
    all.change_brightness(0.3f);
    CHECK(session.has_changes());
    session.open(all.folder / "two.pgm");
    REQUIRE(all.shows("two.pgm"));
    CHECK(session.project_path().empty());

    session.undo();
    REQUIRE(all.shows("three.pgm"));
    CHECK(session.project_path() == all.folder / "p.dapple");
    CHECK(session.has_changes());
    session.undo();
    CHECK_FALSE(session.has_changes());
    session.undo();
    REQUIRE(all.shows("one.pgm"));
    CHECK(session.project_path().empty());
    CHECK(session.settings.drawing.placing.count == 100u);
    CHECK(session.has_changes());
    session.undo();
    CHECK_FALSE(session.has_changes());
}

TEST_CASE(
    "where a picture is gone that undo or redo would open, all stays as it is, and can be tried again") {
    Openings all;
    Session& session = all.session;
    all.change_brightness(0.1f);
    session.open(all.folder / "two.pgm");
    REQUIRE(all.shows("two.pgm"));
    all.change_brightness(0.2f);
    session.undo();
    const ViewerSettings before = session.settings;
    fs::rename(all.folder / "one.pgm", all.folder / "away.pgm");
    session.undo();
    REQUIRE(all.brings([&] { return session.banner.kind == BannerKind::error; }));
    CHECK(session.banner.message.find("one.pgm") != std::string::npos);
    CHECK(session.settings == before);
    CHECK(session.picture_path() == all.folder / "two.pgm");
    CHECK(session.undo_words() == "opening two.pgm");
    CHECK(session.redo_words() == "Brightness");
    fs::rename(all.folder / "away.pgm", all.folder / "one.pgm");
    session.undo();
    CHECK(all.shows("one.pgm"));
    CHECK(session.banner.kind != BannerKind::error);
}

TEST_CASE(
    "while a picture is being read nothing is undone, and what is then set is a step with its opening") {
    Openings all;
    Session& session = all.session;
    all.change_brightness(0.1f);
    session.open(all.folder / "two.pgm");
    all.change_brightness(0.2f);
    session.undo();
    session.redo();
    CHECK(all.brightness() == 0.2f);
    REQUIRE(all.shows("two.pgm"));
    CHECK(all.brightness() == 0.2f);
    session.undo();
    REQUIRE(all.shows("one.pgm"));
    CHECK(all.brightness() == 0.1f);
}

}  // namespace dapple
