// Projects and other settings in files: nothing is lost, and whatever is wrong is told in a sentence.

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/commands/settings_options.h"
#include "app/viewer/model/session.h"
#include "app/viewer/model/viewer_settings.h"
#include "core/image/mask.h"
#include "core/settings/drawing_fields.h"
#include "core/settings/fields.h"
#include "io/settings/project.h"
#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const fs::path kPaper16 = source_folder() / "assets/tiles/paper16.tile";

/// No field is as it usually is: what is forgotten in a file comes back wrong.
ViewerSettings nothing_usual() {
    ViewerSettings all;
    all.drawing = {
        .automatic_tone = false,
        .tone_strength = 0.3,
        .automatic_exposure = false,
        .tone = {.exposure = -1.3f,
                 .black_point = 0.1f,
                 .white_point = 0.9f,
                 .contrast = 0.2f,
                 .brightness = -0.3f,
                 .gamma = 1.7f,
                 .blur = 3.3f,
                 .detail = 0.6f,
                 .black = 0.85,
                 .invert = true},
        .mask = Mask(Grid<std::uint8_t>(3, 2, 77), Grid<std::uint8_t>(3, 2, 33)),
        .tile = "14217,2895/16",
        .ranking = RankingMethod::farthest,
        .placer = PlacerKind::figure8,
        .placing = {.scale = 1234.5, .count = {}, .threads = 0},
        .relax = 7,
        .settle_for = SettleFor::samples,
        .dot_size = {.sizing = DotSizing::by_tone, .radius_mm = 0.3, .smallest_mm = 0.11, .largest_mm = 0.77},
        .page = {.paper = Paper::custom,
                 .orientation = PageOrientation::landscape,
                 .width_mm = 321.5,
                 .height_mm = 123.25,
                 .margins = Margins{11, 12.5, 13, 14},
                 .fit = PageFit::fill,
                 .crop = Crop{{{10, 20}, {90, 80.5}}, Crop::Unit::pixels},
                 .quarter_turns = 3,
                 .mirrored = true},
        .sheets = {.columns = 3, .rows = 2, .overlap_mm = 12.5},
        .pens =
            [] {
                PenChoice pens = parse_pens("greys:0.4");
                pens.order = PenOrder::darkest;
                pens.ink = PenInk::opaque;
                return pens;
            }(),
        .registration = true,
        .ink = parse_colour("#1d3557"),
        .paper = parse_colour("#f1faee"),
        .background = true,
        .show_tiles = true,
        .contours = 0.4,
        .solid = 0.8,
        .style = DrawingStyle::nearest,
        .mark = parse_dot_mark("M0,0 L1,1"),
        .pen_width_mm = 0.7,
        .edits = "bare r1.5 2,3 4.25,5;bare 1,1 2,1 1,2;dot r0.5 p2 6,7;"};
    all.density = {DensitySource::grey, 0.3};
    all.picture_opacity = 0.4f;
    all.zoom_mode = ZoomMode::constant_density;
    all.colouring = DotColouring::rank;
    all.deepest_level = 3;
    all.comparison = {.on = true,
                      .placer = PlacerKind::figure8,
                      .tile = "paper20",
                      .ranking = RankingMethod::energy,
                      .by = CompareBy::count,
                      .divider = 0.3f};
    all.loupe = {true, 2};
    all.origins = true;
    all.unit = LengthUnit::inch;
    all.saving = {.order = DotOrder::priority,
                  .dpi = 600,
                  .tool = GcodeTool::servo,
                  .machine = Machine::grbl_pen,
                  .bits = 16,
                  .gcode_template = {"move G1 X{x} Y{y}\ndot G4 P{dwell}\n", "own.txt"},
                  .feed_mm_per_min = 1234,
                  .dwell_s = 0.5,
                  .acceleration_mm_per_s2 = 750,
                  .pen_up = 25,
                  .pen_down = 75.5,
                  .laser_power = 900,
                  .separations = true,
                  .pen_files = true,
                  .region = parse_region("1.1,2.2,3.3x4.4")};
    return all;
}

Describe all_of(ViewerSettings& settings) {
    return [&settings](Fields& fields) { describe(fields, settings); };
}

/// What reading a file of that text says; empty if nothing.
std::string complaint_about(const std::string& text) {
    const TemporaryFolder folder;
    put_text(folder / "p.dapple", text);
    ViewerSettings settings;
    try {
        read_project(folder / "p.dapple", all_of(settings));
        return "";
    } catch (const std::runtime_error& error) {
        std::string sentence = error.what();
        const std::string where = folder.path().string() + "/";
        for (auto at = sentence.find(where); at != sentence.npos; at = sentence.find(where))
            sentence.erase(at, where.size());
        return sentence;
    }
}

/// "/drawing/tone/gamma" and so on, of all values that are no objects.
void check_all_differ(const Json& one, const Json& other) {
    const Json flat = one.flatten(), flat_other = other.flatten();
    REQUIRE(flat.size() > 30);
    for (const auto& each : flat.items()) {
        const std::string& name = each.key();
        CAPTURE(name);
        if (name != "/dapple" && name != "/picture")
            CHECK(each.value() != flat_other.value(name, Json("not there")));
    }
}

/// A window's session, driven as the window does.
struct ProjectSession {
    Session session{DrawingSettings{}, [] {}};

    ProjectSession() {
        session.settings.drawing.tile = "paper16";
        session.settings.drawing.relax = 0;
        session.open_sample();
    }
    template <class Done>
    void until(Done done) {
        const Zoom zoom{.camera = fitted({800, 600}, {1, 1})};
        REQUIRE(wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return done();
        }));
    }
    std::string exported(const fs::path& file) {
        session.save(file);
        until([&] { return session.saved_path() == file; });
        return text_of(file);
    }
};

std::string rendered(const std::string& arguments, const fs::path& output) {
    CLI::App program;
    const Command command = add_render_command(program);
    program.parse("render " + arguments + " -o " + output.string());
    return text_of(output);
}

}  // namespace

TEST_CASE("the command draws a project byte for byte as the window exports it") {
    const TemporaryFolder folder;
    fs::copy_file(source_folder() / "assets/icon_64.png", folder / "cat.png");
    const std::string project = (folder / "p.dapple").string();
    ProjectSession window;
    window.session.open(folder / "cat.png");
    window.until([&] { return window.session.pictures() > 0 && !window.session.picture().file.empty(); });
    DrawingSettings& drawing = window.session.settings.drawing;
    drawing.automatic_tone = false;
    drawing.tone.contrast = 0.3f;
    drawing.tone.detail = 0.4f;
    drawing.dot_size = {.sizing = DotSizing::by_tone, .smallest_mm = 0.4, .largest_mm = 1.2};
    drawing.tile = "paper20";
    drawing.background = drawing.show_tiles = true;
    drawing.relax = 2;
    drawing.paper = parse_colour("#f1faee");
    BrushStroke stroke({}, {64, 64}, {.kind = BrushKind::none, .radius = 0.2});
    stroke.go_to({0.3, 0.4});
    drawing.mask = stroke.mask();
    window.session.settings.saving = {DotOrder::priority, 50};
    window.session.save_project(project);
    for (const char* name : {"a.svg", "a.png", "a.csv"}) {
        CAPTURE(name);
        const std::string exported = window.exported(folder / name);
        CHECK(exported.size() > 10'000);
        CHECK(rendered(project, folder / ("command_" + std::string(name))) == exported);
    }
    // A part of it too, until all is asked for.
    const std::string whole = text_of(folder / "a.csv");
    window.session.settings.saving.region = parse_region("20,30,100x50.5");
    const std::string part = window.exported(folder / "part.csv");
    CHECK(part.size() < whole.size() / 3);
    window.session.save_project(project);
    CHECK(rendered(project, folder / "command_a.csv") == part);
    CHECK(rendered("--region all " + project, folder / "command_a.csv") == whole);
    window.session.settings.saving.region.reset();
    window.session.save_project(project);
    // Options given beside it say otherwise.
    drawing.dot_size = {};
    drawing.placing.count = 500;
    drawing.tone.contrast = -0.2f;
    drawing.dot_size = {.sizing = DotSizing::fixed, .radius_mm = 0.5};
    drawing.pens = parse_pens("cmyk");
    CHECK(rendered("--dots 500 --contrast -0.2 --dot-radius 0.5 --pens cmyk " + project, folder / "b.svg") ==
          window.exported(folder / "c.svg"));
}

TEST_CASE("a drawing has its settings inside it, which the window and the command take from it") {
    const TemporaryFolder folder;
    const std::string icon = (source_folder() / "assets/icon_64.png").string();
    fs::copy_file(kPaper16, folder / "a&b<c>.tile");
    const std::string options = " --dots 300 --relax 0 --tone true --gamma 1.3 --ink '#1d3557' --tile '" +
                                (folder / "a&b<c>.tile").string() + "'";
    for (const char* name : {"a.svg", "a.png"}) {
        const std::string first = (folder / name).string(),
                          again = (folder / ("again" + std::string(name))).string();
        CAPTURE(first);
        const std::string drawn = rendered(icon + options, first);
        CHECK(rendered("--settings-from " + first + " " + icon, again) == drawn);

        ProjectSession window;
        window.session.settings.picture_opacity = 0.5f;
        window.session.take_dropped(first);
        const DrawingSettings& drawing = window.session.settings.drawing;
        CHECK(window.session.banner.kind == BannerKind::notice);
        CHECK(drawing.placing.count == 300);
        CHECK(drawing.tone.gamma == 1.3f);
        CHECK(drawing.tile == (folder / "a&b<c>.tile").string());
        CHECK(window.session.settings.picture_opacity == 0.5f);
    }
    // Other readers take both as before.
    pugi::xml_document xml;
    REQUIRE(xml.load_file((folder / "a.svg").c_str(), pugi::parse_full));
    const Json said = Json::parse(xml.child("svg").child("metadata").child("dapple:settings").text().get());
    CHECK(said["drawing"]["tile"]["file"] == "a&b<c>.tile");
    CHECK(said["drawing"].size() == 6);
    // A PNG without settings is a picture; an SVG without is none.
    CHECK(!settings_inside(icon));
    put_text(folder / "other.svg", "<svg></svg>");
    CHECK_THROWS_WITH(settings_from(folder / "other.svg"),
                      doctest::Contains("other.svg: has no Dapple settings"));
    const std::string damaged = "\x89PNG\r\n\x1a\n\xff\xff\xff\xfftEXtdapple";
    put_text(folder / "damaged.png", damaged + std::string(20, '\0'));
    CHECK(!settings_inside(folder / "damaged.png"));
}

TEST_CASE("opening a project brings picture and settings, and undo takes the settings back") {
    const TemporaryFolder folder;
    fs::copy_file(source_folder() / "assets/icon_64.png", folder / "icon.png");
    ViewerSettings saved = nothing_usual();
    save_project(folder / "p.dapple", {folder / "icon.png"}, all_of(saved));
    ProjectSession window;
    Session& session = window.session;
    window.until([&] { return session.pictures() == 1; });
    session.remember(false);
    const ViewerSettings before = session.settings;

    session.take_dropped(folder / "none.dapple");
    CHECK(session.banner.message == (folder / "none.dapple").string() + ": no such file");
    CHECK(session.settings == before);

    session.take_dropped(folder / "p.dapple");
    CHECK(session.settings == saved);
    CHECK(session.project_path() == folder / "p.dapple");
    session.settings.density.source = DensitySource::photograph;
    window.until([&] { return session.picture().file == folder / "icon.png"; });
    session.remember(false);
    session.undo();
    CHECK(session.settings == before);
    // Another picture is no longer that project.
    session.open(folder / "icon.png");
    CHECK(session.project_path().empty());
}

TEST_CASE("of a project whose picture cannot be read nothing is taken, and the one before goes on") {
    const TemporaryFolder folder;
    fs::copy_file(source_folder() / "assets/icon_64.png", folder / "icon.png");
    put_text(folder / "damaged.png", "\x89PNG\r\n\x1a\n and no more");
    ViewerSettings usual, other;
    other.drawing.tone.gamma = 1.5f;
    save_project(folder / "a.dapple", {folder / "icon.png", {}, R"({"dapple": 1, "by": "hand"})"},
                 all_of(usual));
    save_project(folder / "b.dapple", {folder / "damaged.png"}, all_of(other));
    const std::string damaged_one = text_of(folder / "b.dapple");
    ProjectSession window;
    Session& session = window.session;
    window.until([&] { return session.pictures() == 1; });
    session.take_dropped(folder / "a.dapple");
    window.until([&] { return session.picture().file == folder / "icon.png"; });
    session.remember(false);
    const ViewerSettings before = session.settings;

    session.take_dropped(folder / "b.dapple");
    session.remember(false);
    window.until([&] { return session.banner.kind == BannerKind::error; });
    CHECK(session.banner.message.find("damaged.png") != std::string::npos);
    session.remember(false);
    CHECK(session.settings == before);
    CHECK(session.project_path() == folder / "a.dapple");
    session.undo();
    CHECK(session.settings.drawing.tone.gamma == 1);
    session.redo();
    session.save_project(session.project_path());
    CHECK(text_of(folder / "b.dapple") == damaged_one);
    const Json kept = Json::parse(text_of(folder / "a.dapple"));
    CHECK(kept["by"] == "hand");
    CHECK(kept["picture"]["file"] == "icon.png");
}

TEST_CASE("a project whose picture is missing opens, keeps its name when saved, and takes the one found") {
    const TemporaryFolder folder;
    const fs::path icon = source_folder() / "assets/icon_64.png", file = folder / "p.dapple";
    ViewerSettings saved;
    saved.drawing.tone.gamma = 1.5f;
    save_project(file, {folder / "gone.png"}, all_of(saved));
    const Json named = Json::parse(text_of(file))["picture"];
    ProjectSession window;
    Session& session = window.session;
    window.until([&] { return session.pictures() == 1; });

    session.take_dropped(file);
    CHECK(session.settings.drawing.tone.gamma == 1.5f);
    CHECK(session.banner.message.find("gone.png is not there") != std::string::npos);
    CHECK(session.banner.offer == "Find the picture");
    CHECK(session.picture_is_missing());
    session.settings.drawing.tone.gamma = 1.25f;
    session.save_project(session.project_path());
    const Json again = Json::parse(text_of(file));
    CHECK(again["picture"] == named);
    CHECK(again["drawing"]["tone"]["gamma"] == 1.25);

    session.find_picture(folder / "not_there.png");
    window.until([&] { return session.banner.message.find("not_there.png") != std::string::npos; });
    CHECK(session.picture_is_missing());
    CHECK(session.banner.offer == "Find the picture");
    session.find_picture(icon);
    window.until([&] { return session.picture().file == icon; });
    CHECK_FALSE(session.picture_is_missing());
    CHECK(session.project_path() == file);
    CHECK(session.settings.drawing.tone.gamma == 1.25f);
    session.save_project(file);
    CHECK(Json::parse(text_of(file))["picture"]["absolute"] == icon.string());

    // A picture that was asked for before it, and cannot be read, takes nothing back.
    save_project(folder / "q.dapple", {folder / "gone.png"}, all_of(saved));
    session.open(folder / "not_there.png");
    session.take_dropped(folder / "q.dapple");
    window.until([&] { return session.banner.message.find("not_there.png") != std::string::npos; });
    CHECK(session.project_path() == folder / "q.dapple");
    CHECK(session.banner.offer == "Find the picture");
}

TEST_CASE("a mask's levels as text come back level for level") {
    Grid<std::uint8_t> levels(40, 30);
    for (std::size_t i = 0; i < levels.values.size(); ++i)
        levels.values[i] = static_cast<std::uint8_t>(i * i % 251);
    CHECK(unpacked_levels(packed_levels(levels), 40, 30).values == levels.values);
    CHECK_THROWS(unpacked_levels(packed_levels(levels), 40, 29));
}

TEST_CASE("a project brings back every setting") {
    const TemporaryFolder folder;
    ViewerSettings saved = nothing_usual(), usual, read;
    save_project(folder / "p.dapple", {}, all_of(saved));
    save_project(folder / "usual.dapple", {}, all_of(usual));
    // Or else it could be forgotten without being missed.
    check_all_differ(Json::parse(text_of(folder / "p.dapple")),
                     Json::parse(text_of(folder / "usual.dapple")));
    read_project(folder / "p.dapple", all_of(read));
    CHECK(read == saved);

    ViewerSettings back = nothing_usual();
    read_project(folder / "usual.dapple", all_of(back));
    CHECK(back == usual);
}

TEST_CASE("what only differs from the usual settings is enough to bring them back") {
    ViewerSettings saved = nothing_usual(), usual, read;
    const SettingsPlace place{"here.svg", FileNames::relative};
    const std::string all = changed_settings(place, all_of(saved), all_of(usual));
    read_settings(all, place, all_of(read));
    CHECK(read == saved);
    CHECK(changed_settings(place, all_of(usual), all_of(usual)) == R"({"dapple":1})");
    ViewerSettings by_scale;
    by_scale.drawing.placing.count.reset();
    by_scale.drawing.tone.gamma = 1.1f;
    CHECK(changed_settings(place, all_of(by_scale), all_of(usual)) ==
          R"({"dapple":1,"drawing":{"tone":{"gamma":1.1},"count":null}})");
}

TEST_CASE("a project keeps what this version does not know") {
    const TemporaryFolder folder;
    put_text(folder / "p.dapple",
             R"({"by": "hand", "dapple": 1, "drawing": {"smells": [{"ink": "red"}], "count": 77}})");
    ViewerSettings settings;
    const Project project = read_project(folder / "p.dapple", all_of(settings));
    CHECK(settings.drawing.placing.count == 77);
    settings.drawing.placing.count = 78;
    save_project(folder / "q.dapple", project, all_of(settings));
    const Json saved = Json::parse(text_of(folder / "q.dapple"));
    CHECK(saved["by"] == "hand");
    CHECK(saved["drawing"]["smells"] == Json{{{"ink", "red"}}});
    CHECK(saved["drawing"]["count"] == 78);
}

TEST_CASE("a project finds picture and tile when both have moved with it, and when it has moved alone") {
    const TemporaryFolder folder;
    fs::create_directories(folder / "a/pictures");
    put_text(folder / "a/pictures/cat.png", "a picture");
    fs::copy_file(kPaper16, folder / "a/mine.tile");
    ViewerSettings settings;
    settings.drawing.tile = (folder / "a/mine.tile").string();
    save_project(folder / "a/p.dapple", {folder / "a/pictures/cat.png"}, all_of(settings));

    fs::create_directory(folder / "alone");
    fs::copy_file(folder / "a/p.dapple", folder / "alone/p.dapple");
    ViewerSettings read;
    CHECK(read_project(folder / "alone/p.dapple", all_of(read)).picture == folder / "a/pictures/cat.png");
    CHECK(read.drawing.tile == (folder / "a/mine.tile").string());

    fs::rename(folder / "a", folder / "b");
    CHECK(read_project(folder / "b/p.dapple", all_of(read)).picture == folder / "b/pictures/cat.png");
    CHECK(read.drawing.tile == (folder / "b/mine.tile").string());

    CHECK_THROWS_WITH(read_project(folder / "alone/p.dapple", all_of(read)),
                      doctest::Contains("p.dapple: drawing.tile cannot be found, neither "));
    put_text(folder / "alone/q.dapple",
             R"({"dapple": 1, "picture": {"file": "a.png", "absolute": "/b.png"}})");
    const Project alone = read_project(folder / "alone/q.dapple", all_of(read));
    CHECK(alone.why_missing.find("q.dapple: picture cannot be found, neither ") != std::string::npos);
    CHECK_THROWS_WITH(read_project_input(folder / "alone/q.dapple"), alone.why_missing.c_str());
    // Nothing that has no end, or may never begin.
    REQUIRE(mkfifo((folder / "b/pipe.png").c_str(), 0600) == 0);
    for (const char* odd : {"pipe.png", "/dev/zero", "pictures"}) {
        put_text(folder / "b/odd.dapple", std::string(R"({"dapple": 1, "picture": ")") + odd + "\"}");
        CHECK_THROWS_WITH(read_project(folder / "b/odd.dapple", all_of(read)),
                          doctest::Contains("which is not a regular file; name one that is"));
    }
    put_text(folder / "b/by_hand.dapple", R"({"dapple": 1, "picture": "pictures/cat.png"})");
    CHECK(read_project(folder / "b/by_hand.dapple", all_of(read)).picture == folder / "b/pictures/cat.png");
}

TEST_CASE("a project that is wrong says in a sentence which field, and what it may be") {
    CHECK(complaint_about(R"({"dapple": 1})") == "");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"tone": {"contrast": 7}}})") ==
          "p.dapple: drawing.tone.contrast is 7; give a number from -1 to 1");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"count": 1.5}})") ==
          "p.dapple: drawing.count is 1.5; give a whole number from 1 to 10000000000, or null");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"ink": "blue"}})") ==
          "p.dapple: drawing.ink is \"blue\"; give a colour such as \"#1a2b3c\"");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"placer": ["exact"]}})") ==
          "p.dapple: drawing.placer is a list; give one of exact, figure8");
    CHECK(complaint_about(R"({"dapple": 1, "view": 3})") == "p.dapple: view is 3; give an object, in braces");
    CHECK(
        complaint_about(R"({"dapple": 1, "drawing": {"tone": {"black_point": 0.5, "white_point": 0.5}}})") ==
        "p.dapple: drawing.tone.black_point has to be below white_point");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"tile": "gone.tile"}})") ==
          "p.dapple: drawing.tile cannot be found, gone.tile is not there; put that file back, or name "
          "another");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"edits": "dot 1,2;dot 3"}})") ==
          "p.dapple: drawing.edits is wrong: edit 2, 'dot 3': '' is no number from -100000 to 100000");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"edits": ["dot 1,2"]}})") ==
          "p.dapple: drawing.edits is a list; give a text in quotes");
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"mask": {"width": 513, "height": 1}}})") ==
          "p.dapple: drawing.mask has no width of 1 to 512");
    CHECK(complaint_about(
              R"({"dapple": 1, "drawing": {"mask": {"width": 9, "height": 9, "levels": "Zm9v"}}})") ==
          "p.dapple: drawing.mask has levels that are not as many as width and height say, or damaged");
    const std::string levels = packed_levels(Grid<std::uint8_t>(9, 9, 5));
    CHECK(complaint_about(R"({"dapple": 1, "drawing": {"mask": {"width": 9, "height": 9, "levels": ")" +
                          levels + R"(", "fineness": 3}}})") == "p.dapple: drawing.mask has no fineness");
    CHECK(complaint_about(R"({"dapple": 9})") ==
          "p.dapple: written by a newer Dapple, in version 9 of the format; this one reads version 1");
    CHECK(complaint_about("[1, 2]") == "p.dapple: not Dapple settings, which have \"dapple\": 1");
    CHECK(complaint_about("{\"dapple\": 1,\n \"drawing\" {}}") ==
          "p.dapple: line 2 is not JSON: a quote, comma, bracket or value is missing, or one is too many");
}

TEST_CASE("a hostile project ends in a sentence") {
    const std::string deep(100'000, '[');
    std::string many = R"({"dapple": 1)";
    for (int i = 0; i < 60'000; ++i) many += ",\"k" + std::to_string(i) + "\":1";
    const std::vector<std::string> texts{"",
                                         many + "}",
                                         deep,
                                         "{\"dapple\":1,\"x\":" + deep + std::string(100'000, ']') + "}",
                                         R"({"dapple": 1, "drawing": {"page": {"width_mm": 1e999}}})",
                                         R"({"dapple": 1, "drawing": {"page": {"width_mm": NaN}}})",
                                         R"({"dapple": 1, "drawing": {"page": {"width_mm": null}}})",
                                         R"({"dapple": 1, "drawing": {"relax": 4294967296}})",
                                         R"({"dapple": 1, "drawing": {"count": -1}})",
                                         R"({"dapple": 1, "drawing": {"tone": {"invert": 1}}})",
                                         R"({"dapple": 1, "picture": "a\u0000b"})",
                                         R"({"dapple": 1, "picture": {"absolute": "/"}})",
                                         R"({"dapple": "1"})",
                                         "{\"dapple\": 1, \"picture\": \"\xff\"}",
                                         std::string(2'000'000, ' ')};
    for (const std::string& text : texts) {
        const std::string sentence = complaint_about(text);
        CAPTURE(text.substr(0, 60));
        CAPTURE(sentence);
        CHECK(sentence.starts_with("p.dapple: "));
        CHECK(sentence.find("json") == sentence.npos);
        CHECK(sentence.size() < 200);
    }
}

}  // namespace dapple
