// What the window remembers from one day to the next.

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "app/viewer/shell/memory.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;
using State = nlohmann::json;

struct Home {
    TemporaryFolder folder;
    fs::path config = folder / "config/dapple", state = folder / "state/dapple";

    Memory window() const { return {config, state}; }
    State preferences() const { return State::parse(text_of(config / "preferences.json")); }
    State states() const { return State::parse(text_of(state / "state.json")); }
};

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("what was chosen and what just was so is there on the next day") {
    const Home home;
    Memory today = home.window();
    CHECK_FALSE(today.take_trouble());
    today.preferences.appearance = {Theme::dark, 1.25f};
    today.state.window = {-5, 20, 1000, 700, true};
    today.state.panels_shown = false;
    today.state.panel_width = 420;
    today.state.view = {.zoom_mode = ZoomMode::constant_density,
                        .saving = {.order = DotOrder::space, .dpi = 600}};
    today.state.view.drawing.placing.count = 12'345;
    today.state.view.drawing.page.margins = parse_margins("17mm");
    today.opened("/pictures/cat.jpg");
    today.opened("/other/dog.dapple");
    today.opened("/pictures/cat.jpg");
    today.save();

    Memory next = home.window();
    CHECK_FALSE(next.take_trouble());
    CHECK(next.preferences == today.preferences);
    CHECK(next.state == today.state);
    CHECK(next.state.recent == std::vector<fs::path>{"/pictures/cat.jpg", "/other/dog.dapple"});
    CHECK(next.state.folder == std::vector<fs::path>{"/pictures"});
    CHECK(home.preferences()["theme"] == "dark");
    CHECK(home.states()["window"]["width"] == 1000);
}

TEST_CASE("the desktop's dialog asks for files at first, and our own where that was chosen") {
    const Home home;
    CHECK(Memory().preferences.dialog == DialogChoice::desktop);
    write(home.config / "preferences.json", R"({"dapple": 1, "theme": "dark"})");
    CHECK(home.window().preferences.dialog == DialogChoice::desktop);
    write(home.config / "preferences.json", R"({"dapple": 1, "dialog": "own"})");
    Memory own = home.window();
    CHECK(own.preferences.dialog == DialogChoice::own);
    own.preferences.appearance.theme = Theme::dark;
    own.save();
    CHECK(home.window().preferences.dialog == DialogChoice::own);
}

TEST_CASE("two windows leave each other's recent files and choices alone") {
    const Home home;
    Memory one = home.window(), other = home.window();
    one.opened("/a.png");
    one.preferences.appearance.theme = Theme::dark;
    one.save();
    other.opened("/b.png");
    other.state.panels_shown = false;
    other.save();
    one.forget("/a.png");
    one.opened("/c.png");
    one.save();

    const Memory next = home.window();
    CHECK(next.state.recent == std::vector<fs::path>{"/c.png", "/b.png"});
    CHECK_FALSE(next.state.panels_shown);
    CHECK(next.preferences.appearance.theme == Theme::dark);
}

TEST_CASE("of two windows that save at the same time neither loses the other's files") {
    const Home home;
    const auto open_some = [&](const std::string& name) {
        Memory window = home.window();
        for (int i = 0; i < static_cast<int>(kMostRecent) / 2; ++i) {
            window.opened("/" + name + std::to_string(i));
            window.save();
        }
    };
    {
        std::jthread one([&] { open_some("one"); });
        std::jthread other([&] { open_some("other"); });
    }
    const std::vector<fs::path> recent = home.window().state.recent;
    CHECK(recent.size() == kMostRecent);
    CHECK(std::set(recent.begin(), recent.end()).size() == kMostRecent);
}

TEST_CASE("recent files are few, and each is named once") {
    std::vector<fs::path> recent;
    for (int i = 0; i < 30; ++i) recent = with_recent("/" + std::to_string(i), recent);
    recent = with_recent("/15", recent);
    CHECK(recent.size() == kMostRecent);
    CHECK(recent[0] == "/15");
    CHECK(recent[1] == "/29");
    CHECK(recent.back() == "/10");
}

TEST_CASE("a broken file is moved aside with one sentence, and the rest is still remembered") {
    const Home home;
    Memory before = home.window();
    before.opened("/a.png");
    before.save();
    const std::string broken = R"({"dapple": 1, "theme": "pink"})";
    write(home.config / "preferences.json", broken);

    Memory memory = home.window();
    const std::string trouble = memory.take_trouble().value();
    CHECK(trouble.find("preferences.json: theme") != std::string::npos);
    CHECK(trouble.find("preferences.json.broken") != std::string::npos);
    CHECK_FALSE(memory.take_trouble());
    CHECK(memory.preferences == Preferences{});
    CHECK(memory.state.recent.size() == 1);
    CHECK(text_of(home.config / "preferences.json.broken") == broken);
    CHECK_FALSE(fs::exists(home.config / "preferences.json"));
}

TEST_CASE("any text in the place of what is remembered stops no start") {
    for (const char* text : {"", "[", "{}", "[1, 2]", R"({"dapple": 2})", R"({"dapple": 1, "recent": "a"})",
                             R"({"dapple": 1, "recent": ["a"]})", R"({"dapple": 1, "recent": ["/a\u0000b"]})",
                             R"({"dapple": 1, "window": {"width": -1}})", R"({"dapple": 1, "view": 7})"}) {
        CAPTURE(text);
        const Home home;
        write(home.state / "state.json", text);
        Memory memory = home.window();
        CHECK(memory.take_trouble());
        CHECK(memory.state == WindowState{});
    }
}

TEST_CASE("what a later Dapple remembers beside it stays in the file") {
    const Home home;
    write(home.state / "state.json", R"({"dapple": 1, "later": [1, 2]})");
    Memory memory = home.window();
    memory.opened("/a.png");
    memory.save();
    CHECK(home.states()["later"] == State{1, 2});
    CHECK(home.states()["recent"] == State{"/a.png"});
}

TEST_CASE("a fresh window writes nothing") {
    Memory memory;
    memory.preferences.appearance.theme = Theme::dark;
    memory.opened("/a.png");
    memory.save();
    Memory nowhere{"", ""};
    nowhere.opened("/a.png");
    nowhere.save();
    CHECK(nowhere.state.recent.size() == 1);
}

TEST_CASE(
    "after a window that ended before it could draw the next begins with the usual settings, and says so") {
    const Home home;
    {
        Memory first = home.window();
        first.state.view.drawing.placing.count = 12'345;
        first.state.window = {0, 0, 1000, 700, false};
        first.save();
    }
    CHECK(home.window().state.view.drawing.placing.count ==
          12'345);                       // and what ends in good order is no crash
    write(home.state / "starting", "");  // as a crash leaves it
    Memory next = home.window();
    CHECK(next.take_trouble().value_or("").find("before it could draw") != std::string::npos);
    CHECK(next.state.view == KeptView{});
    CHECK(next.state.window.width == 1000);
    Memory meanwhile = home.window();  // another window, while that one begins
    CHECK_FALSE(meanwhile.take_trouble());
    next.begun();
    CHECK_FALSE(fs::exists(home.state / "starting"));
    CHECK_FALSE(home.window().take_trouble());
}

}  // namespace dapple
