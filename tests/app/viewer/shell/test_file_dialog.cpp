#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "app/viewer/shell/file_dialog.h"
#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/picture_entry.h"
#include "app/viewer/widgets/row.h"
#include "tests/file_text.h"
#include "tests/headless_ui.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

struct Folder {
    Folder() {
        fs::create_directories(root.path() / "b folder");
        fs::create_directories(root.path() / ".hidden");
        for (const char* name : {"Cat.JPG", "ant.png", "notes.txt", ".secret.png", "b folder/inner.tif"})
            std::ofstream(root.path() / name) << "x";
    }
    TemporaryFolder root;
};

struct DialogUi {
    FileDialog dialog;
    std::optional<fs::path> chosen;
    bool option = false;
    int further = 0;  // options
    double number = 3;
    std::string refusal;
    HeadlessUi ui{[this] {
        const auto options = [this](std::size_t) {
            switch_row("Option", option, "An option.");
            slider_row("Number", number, {.min = 1, .max = 9});
            for (int i = 0; i < further; ++i)
                switch_row(("Further " + std::to_string(i)).c_str(), option, "Another option.");
            return refusal;
        };
        if (auto path = dialog.draw(options)) chosen = path;
    }};

    void open(const fs::path& start) {
        ImGui::GetIO().DisplaySize = {900, 700};
        dialog.ask_what_to_open({"Open a picture", {".png", ".tif"}, start});
        for (int i = 0; i < 4; ++i) ui.frame();
    }
    void save(const fs::path& start, const fs::path& own_file = {}) {
        ImGui::GetIO().DisplaySize = {900, 700};
        dialog.ask_where_to_save({.title = "Export",
                                  .formats = {{"SVG", ".svg"}, {"PNG", ".png"}, {"CSV", ".csv"}},
                                  .start = start,
                                  .own_file = own_file,
                                  .has_options = true});
        for (int i = 0; i < 4; ++i) ui.frame();
    }
    void key(Key key, int modifiers = 0) {
        put_modifiers(modifiers);
        ui.key(key);
        put_modifiers(0);
        for (int i = 0; i < 3; ++i) ui.frame();
    }
    /// Whether the middle of something lies in what the ring is around.
    bool has_keys(const std::string& label) const {
        if (!ui.has(kRowWithKeys) || !ui.has(label)) return false;
        const WidgetPlace ring = ui.place(kRowWithKeys);
        const glm::vec2 middle = ui.at(label, 0.5f);
        return middle.x > ring.min.x && middle.x < ring.max.x && middle.y > ring.min.y &&
               middle.y < ring.max.y;
    }
    bool marked(const std::string& label) const {
        return ui.has(kMarkedEntry) && ui.has(label) && ui.place(kMarkedEntry) == ui.place(label);
    }
    void walk_to(const std::string& label) {
        for (int i = 0; i < 12 && !has_keys(label); ++i) key(Key::tab);
        REQUIRE(has_keys(label));
    }
};

}  // namespace

TEST_CASE("a folder's listing has folders first, wanted files by name, nothing hidden") {
    Folder folder;
    auto entries = list_folder(folder.root.path(), {".png", ".jpg"});
    CHECK(entries == std::vector<FolderEntry>{{"b folder", true}, {"ant.png", false}, {"Cat.JPG", false}});
    CHECK(list_folder(folder.root.path(), {}).size() == 4);
    CHECK(list_folder(folder.root.path() / "missing", {}).empty());
}

TEST_CASE("walking into a folder and opening a picture there gives its path") {
    Folder folder;
    DialogUi f;
    f.open(folder.root.path());
    f.ui.click("b folder/");
    f.ui.frame();
    f.ui.click("Parent folder");
    f.ui.frame();
    CHECK_FALSE(f.ui.has("inner.tif"));
    f.ui.click("b folder/");
    f.ui.frame();
    f.ui.click("inner.tif");
    CHECK(f.chosen == folder.root.path() / "b folder" / "inner.tif");
    CHECK_FALSE(f.dialog.is_open());
}

TEST_CASE("names with ## in them are shown whole, and each is its own entry") {
    const auto drawn = [](const char* name) {
        HeadlessUi ui([name] { text_entry(name, false); });
        ui.frame();
        return ImGui::GetDrawData()->TotalVtxCount;
    };
    CHECK(drawn("a##b") == drawn("axxb"));
    CHECK(drawn("a###b") == drawn("axxxb"));
    Folder folder;
    for (const char* name : {"a##b.png", "a##c.png", "a###x.png", "b###x.png"})
        std::ofstream(folder.root.path() / name) << "x";
    for (const char* name : {"a##c.png", "b###x.png"}) {
        DialogUi f;
        f.open(folder.root.path());
        f.ui.click(name);
        CHECK(f.chosen == folder.root.path() / name);
    }
}

TEST_CASE("Cancel chooses nothing") {
    Folder folder;
    DialogUi f;
    f.open(folder.root.path());
    f.ui.click("Cancel");
    CHECK_FALSE(f.chosen);
    CHECK_FALSE(f.dialog.is_open());
}

TEST_CASE("a click on a file takes its name, to be saved as that, and one on a folder keeps the name") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "cat.svg");
    f.ui.click("ant.png");
    f.ui.click("b folder/");
    CHECK_FALSE(f.chosen);
    f.ui.click("Accept");
    CHECK(f.chosen == folder.root.path() / "b folder" / "ant.png");
}

TEST_CASE("saving fills the name in, and the format row changes its ending") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "cat.svg");
    f.ui.click("CSV");
    f.ui.click("Accept");
    REQUIRE(f.chosen);
    CHECK(*f.chosen == folder.root.path() / "cat.csv");
}

TEST_CASE("a folder that is not there, or an ending that is unknown, is refused while the dialog stays") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "missing" / "cat.svg");
    f.ui.click("Accept");
    CHECK_FALSE(f.chosen);
    CHECK(f.dialog.is_open());
    f.save(folder.root.path() / "cat.doc");
    f.ui.frame();
    f.ui.click("Accept");
    CHECK_FALSE(f.chosen);
}

TEST_CASE("a name without an ending gets that of the format chosen, which stays chosen while it is typed") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "out");
    f.ui.click("Accept");
    CHECK(f.chosen == folder.root.path() / "out.svg");
    f.save(folder.root.path() / "out.png");
    f.ui.click("Path");
    f.ui.key(Key::end);
    for (int letter = 0; letter < 4; ++letter) f.ui.key(Key::backspace);
    f.ui.click("Accept");
    CHECK(f.chosen == folder.root.path() / "out.png");
}

TEST_CASE("a file that is there is replaced only when that was asked for twice") {
    Folder folder;
    DialogUi f;
    const fs::path there = folder.root.path() / "ant.png";
    f.save(there);
    f.ui.click("Accept");
    CHECK_FALSE(f.chosen);
    REQUIRE(f.ui.has("Replace"));
    f.ui.click("Cancel");
    CHECK_FALSE(f.chosen);
    CHECK(f.dialog.is_open());
    f.ui.click("Accept");
    f.ui.click("Replace");
    CHECK(f.chosen == there);
}

TEST_CASE("a name that stands for several files is asked about for any of them that is there") {
    Folder folder;
    DialogUi f;
    const fs::path root = folder.root.path(), there = root / "b.png";
    f.dialog.ask_where_to_save(
        {.title = "Export", .formats = {{"PNG", ".png"}}, .start = there, .files = [](const fs::path& name) {
             return std::vector{name.parent_path() / "none.png", name.parent_path() / "ant.png"};
         }});
    for (int i = 0; i < 4; ++i) f.ui.frame();
    f.ui.click("Accept");
    CHECK_FALSE(f.chosen);
    f.ui.click("Replace");
    CHECK(f.chosen == there);
    // The name's own file is not one of them.
    f.dialog.ask_where_to_save({.title = "Export",
                                .formats = {{"PNG", ".png"}},
                                .start = root / "ant.png",
                                .files = [&](const fs::path&) { return std::vector{root / "none.png"}; }});
    for (int i = 0; i < 4; ++i) f.ui.frame();
    f.ui.click("Accept");
    CHECK(f.chosen == root / "ant.png");
}

TEST_CASE("Enter asks before it replaces a file, and another Enter does it") {
    Folder folder;
    DialogUi f;
    const fs::path there = folder.root.path() / "ant.png";
    f.save(there);
    f.ui.key(Key::enter);
    CHECK_FALSE(f.chosen);
    REQUIRE(f.ui.has("Replace"));
    f.ui.key(Key::enter);
    CHECK(f.chosen == there);
}

TEST_CASE("Enter chooses as soon as the dialog is there") {
    Folder folder;
    DialogUi f;
    f.dialog.ask_where_to_save(
        {.title = "Export", .formats = {{"SVG", ".svg"}}, .start = folder.root.path() / "new.svg"});
    while (!f.ui.has("Path")) f.ui.frame();
    f.ui.key(Key::enter);
    CHECK(f.chosen == folder.root.path() / "new.svg");
}

TEST_CASE("files of an own drawing that it had not before are asked about as any others") {
    Folder folder;
    const fs::path own = folder.root.path() / "own.svg", pen = folder.root.path() / "own-1.svg",
                   other = folder.root.path() / "own-2.svg";
    for (const fs::path& file : {pen, other}) put_text(file, "drawn");
    DialogUi f;
    ImGui::GetIO().DisplaySize = {900, 700};
    std::vector<fs::path> written{pen};
    f.dialog.ask_where_to_save({.title = "Export",
                                .formats = {{"SVG", ".svg"}},
                                .start = own,
                                .own_file = own,
                                .own_files = {pen},
                                .files = [&](const fs::path&) { return written; }});
    for (int i = 0; i < 4; ++i) f.ui.frame();
    written.push_back(other);  // as a row of the dialog may have it
    f.ui.click("Accept");
    CHECK_FALSE(f.chosen);
    REQUIRE(f.ui.has("Replace"));
    f.ui.click("Replace");
    CHECK(f.chosen == own);
    f.chosen.reset();
    written = {pen};
    f.dialog.ask_where_to_save({.title = "Export",
                                .formats = {{"SVG", ".svg"}},
                                .start = own,
                                .own_file = own,
                                .own_files = {pen},
                                .files = [&](const fs::path&) { return written; }});
    for (int i = 0; i < 4; ++i) f.ui.frame();
    f.ui.click("Accept");
    CHECK(f.chosen == own);
}

TEST_CASE("another name takes the question whether to replace back") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "ant.png");
    f.ui.click("Accept");
    REQUIRE(f.ui.has("Replace"));
    f.ui.click("SVG");
    CHECK_FALSE(f.ui.has("Replace"));
    f.ui.click("Accept");
    CHECK(f.chosen == folder.root.path() / "ant.svg");
}

TEST_CASE("a format may have two endings, and the name keeps the one that was typed") {
    Folder folder;
    DialogUi f;
    ImGui::GetIO().DisplaySize = {900, 700};
    f.dialog.ask_where_to_save({.title = "Export",
                                .formats = {{"SVG", ".svg"}, {"G-code", ".gcode", ".nc"}},
                                .start = folder.root.path() / "cat.NC"});
    for (int i = 0; i < 4; ++i) f.ui.frame();
    f.ui.click("Accept");
    CHECK(f.chosen == folder.root.path() / "cat.NC");
}

TEST_CASE("the file that was written last is written again without a question") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "ant.png", folder.root.path() / "ant.png");
    f.ui.click("Accept");
    CHECK(f.chosen == folder.root.path() / "ant.png");
}

TEST_CASE("after a path that is not there, or a folder, typing goes on behind it") {
    Folder folder;
    DialogUi f;
    f.open(folder.root.path());
    f.ui.type((folder.root.path() / "b folders").c_str());  // all of what was there was selected
    f.key(Key::enter);
    CHECK(f.dialog.is_open());
    f.key(Key::backspace);
    f.key(Key::enter);
    CHECK(f.ui.has("inner.tif"));
    f.ui.type("inner.tif");
    f.key(Key::enter);
    CHECK(f.chosen == folder.root.path() / "b folder" / "inner.tif");
}

TEST_CASE("so it does after a click on the button, and after what is there is kept") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "missing" / "cat.svg");
    f.ui.click("Accept");
    f.ui.frame();
    for (int letter = 0; letter < 15; ++letter) f.key(Key::backspace);
    f.ui.type("ant.png");
    f.key(Key::enter);
    REQUIRE(f.ui.has("Replace"));
    f.key(Key::escape);
    CHECK_FALSE(f.ui.has("Replace"));
    REQUIRE(f.dialog.is_open());
    for (int letter = 0; letter < 3; ++letter) f.key(Key::backspace);
    f.ui.type("csv");
    f.key(Key::enter);
    CHECK(f.chosen == folder.root.path() / "ant.csv");
}

TEST_CASE("Tab walks from the path to the folder, the format, its options and the buttons, and back") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "cat.svg");
    const std::vector<std::string> order{"ant.png", "SVG", "Option", "Number", "Accept", "Cancel", "Path"};
    for (const std::string& name : order) {
        CAPTURE(name);
        f.key(Key::tab);
        // A choice side by side is noted by its first entry, and the folder by any.
        CHECK(f.has_keys(name));
    }
    for (auto name = order.rbegin() + 1; name != order.rend(); ++name) {
        CAPTURE(*name);
        f.key(Key::tab, GLFW_MOD_SHIFT);
        CHECK(f.has_keys(*name));
    }
    f.key(Key::tab, GLFW_MOD_SHIFT);
    REQUIRE(f.has_keys("Path"));
    f.key(Key::backspace);  // in the field again, behind what is there
    f.ui.type("G");
    f.key(Key::enter);
    CHECK(f.chosen == folder.root.path() / "cat.svG");
}

TEST_CASE(
    "a row of the options may have the keys at first, and the key that opened the dialog accepts nothing") {
    Folder folder;
    DialogUi f;
    f.further = 40;  // so that it is scrolled to
    ImGui::GetIO().DisplaySize = {900, 700};
    static_cast<WidgetNotes*>(ImGui::GetIO().UserData)->reveal = ListedRow{.label = "Further 39"};
    f.dialog.ask_where_to_save({.title = "Export",
                                .formats = {{"SVG", ".svg"}, {"PNG", ".png"}},
                                .start = folder.root.path() / "a.svg",
                                .has_options = true,
                                .begins_below = true});
    f.key(Key::enter);
    CHECK(f.dialog.is_open());
    CHECK_FALSE(f.chosen);
    CHECK_FALSE(f.option);
    REQUIRE(f.has_keys("Further 39"));
    CHECK(f.ui.place("Further 39").max.y < f.ui.place("Accept").min.y);
    f.key(Key::space);
    CHECK(f.option);
    f.key(Key::escape);
    CHECK_FALSE(f.dialog.is_open());
}

TEST_CASE("Tab walks options that scroll in their order, and one row alone has the keys") {
    Folder folder;
    DialogUi f;
    f.further = 6;
    f.save(folder.root.path() / "cat.svg");
    ImGui::GetIO().DisplaySize = {900, 420};
    for (int i = 0; i < 4; ++i) f.ui.frame();
    REQUIRE(f.ui.place("Further 5").min.y > f.ui.place("Accept").max.y);  // out of sight
    for (const char* name : {"ant.png", "SVG", "Option", "Number", "Further 0"}) {
        CAPTURE(name);
        f.key(Key::tab);
        CHECK(f.has_keys(name));
    }
    for (int i = 0; i < 5; ++i) f.key(Key::tab);
    CHECK(f.has_keys("Further 5"));
    CHECK(f.ui.place("Further 5").max.y < f.ui.place("Accept").min.y);  // it was scrolled to
    f.key(Key::tab);
    CHECK(f.has_keys("Accept"));
}

TEST_CASE("by keyboard alone a folder, a format and an option are chosen, and the drawing is saved") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "cat.svg");
    f.walk_to("ant.png");
    f.key(Key::down);  // past the way up
    CHECK(f.marked("b folder/"));
    f.key(Key::enter);
    REQUIRE(f.dialog.is_open());
    f.walk_to("SVG");
    f.key(Key::right);
    f.walk_to("Option");
    f.key(Key::enter);
    CHECK(f.option);
    CHECK_FALSE(f.chosen);
    f.walk_to("Number");
    f.key(Key::enter);
    f.ui.type("7");
    f.key(Key::enter);
    CHECK(f.number == 7);
    CHECK_FALSE(f.chosen);
    f.walk_to("Accept");
    f.key(Key::space);
    CHECK(f.chosen == folder.root.path() / "b folder" / "cat.png");
}

TEST_CASE("Escape ends what is typed into an option, and only then the dialog") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "cat.svg");
    f.walk_to("Number");
    f.key(Key::enter);
    f.ui.type("7");
    f.key(Key::escape);
    CHECK(f.dialog.is_open());
    CHECK(f.number == 3);
    f.key(Key::escape);
    CHECK_FALSE(f.dialog.is_open());
    // Opened again, none of its buttons has the keys still.
    f.save(folder.root.path() / "cat.svg");
    f.walk_to("Cancel");
    f.key(Key::enter);
    f.save(folder.root.path() / "cat.svg");
    f.key(Key::enter);
    CHECK(f.chosen == folder.root.path() / "cat.svg");
}

TEST_CASE("what is typed leaves those entries that begin so, of which Enter opens the first") {
    Folder folder;
    const fs::path root = folder.root.path();
    std::ofstream(root / "Zebra.png") << "x";
    DialogUi f;
    f.open(root);
    CHECK(f.ui.has("ant.png"));
    for (const char* letter : {"z", "e"}) f.ui.type(letter);
    f.ui.frame();
    CHECK(f.ui.has("Zebra.png"));
    CHECK_FALSE(f.ui.has("ant.png"));
    f.key(Key::enter);
    CHECK(f.chosen == root / "Zebra.png");

    f.open(root);
    f.ui.type((root / "b folder/").c_str());
    f.ui.frame();
    CHECK(f.ui.has("inner.tif"));
    f.key(Key::escape);

    f.open(root);
    f.ui.type("b f");
    f.key(Key::enter);
    CHECK(f.ui.has("inner.tif"));
    f.ui.type("nothing");
    f.key(Key::enter);
    CHECK(f.dialog.is_open());
}

TEST_CASE("arrows and letters mark an entry of the list, and Enter opens it") {
    Folder folder;
    const fs::path root = folder.root.path();
    DialogUi f;
    f.open(root);
    f.key(Key::tab);
    for (int i = 0; i < 2; ++i) f.key(Key::down);
    CHECK(f.marked("ant.png"));
    f.key(Key::up);
    CHECK(f.marked("b folder/"));
    f.ui.type("a");
    f.ui.frame();
    f.ui.frame();
    CHECK(f.marked("ant.png"));
    f.key(Key::enter);
    CHECK(f.chosen == root / "ant.png");
}

TEST_CASE("Tab completes what is typed, as far as all names agree that begin so, and else walks on") {
    Folder folder;
    const fs::path root = folder.root.path();
    const auto in = [&](const fs::path& typed) {
        return completed(typed, list_folder((root / typed).parent_path(), {".png", ".jpg", ".tif"}));
    };
    CHECK(in("a") == "ant.png");
    CHECK(in("c") == "Cat.JPG");
    CHECK(in("B F") == "b folder/");
    CHECK(in(root / "b folder/in") == (root / "b folder/inner.tif").string());
    CHECK(in("z") == "z");
    CHECK(in("").empty());
    std::ofstream(root / "antler.png") << "x";
    CHECK(in("an") == "ant");
    DialogUi f;
    f.open(root);
    for (const char* letter : {"a", "n"}) f.ui.type(letter);
    f.key(Key::tab);
    f.ui.type("l");
    f.key(Key::tab);
    f.key(Key::enter);
    CHECK(f.chosen == root / "antler.png");
}

TEST_CASE("what is wrong with a name is said beside the buttons and never under them") {
    Folder folder;
    DialogUi f;
    f.save(folder.root.path() / "drawing.txt");
    f.ui.click("Accept");
    CHECK(f.dialog.is_open());
    REQUIRE(f.ui.has("Trouble"));
    CHECK(f.ui.place("Trouble").min.x > f.ui.place("Cancel").max.x);
}

TEST_CASE("nothing is saved that cannot be written, by no key and no click, until it can") {
    Folder folder;
    DialogUi f;
    f.refusal = "No PDF is so large.";
    f.save(folder.root.path() / "cat.svg");
    f.ui.click("Accept");
    f.key(Key::enter);
    f.ui.click("Path");
    f.key(Key::enter);
    CHECK_FALSE(f.chosen);
    CHECK(f.dialog.is_open());
    f.refusal.clear();
    f.key(Key::enter);
    CHECK(f.chosen == folder.root.path() / "cat.svg");
}

TEST_CASE("a name is shown as it is, and one that is two lines or no text as one line of text") {
    const TemporaryFolder folder;
    for (const char* name : {"a##b.png", "two\nlines.png", "\xff.png"})
        std::ofstream(folder.path() / name) << "x";
    DialogUi f;
    f.open(folder.path());
    CHECK(f.ui.has("a##b.png"));
    CHECK(f.ui.has("two\\nlines.png"));
    CHECK(f.ui.has("\\xff.png"));
    f.ui.click("\\xff.png");
    CHECK(f.chosen == folder.path() / "\xff.png");
}

TEST_CASE(
    "in a folder whose name is no text, or has rare letters, names are typed and deleted as elsewhere") {
    for (const char* name : {"lat\xfcin", "\xf0\x9f\x93\xb7"}) {
        CAPTURE(name);
        const TemporaryFolder root;
        const fs::path folder = root.path() / name;
        fs::create_directory(folder);
        std::ofstream(folder / "cat.png") << "x";
        {
            DialogUi f;
            f.open(folder);
            f.key(Key::backspace);  // all of it was selected
            f.ui.type("cat.png");
            f.key(Key::enter);
            CHECK(f.chosen == folder / "cat.png");
        }
        DialogUi f;
        f.save(folder / "cat.svg");
        f.key(Key::enter);
        CHECK(f.chosen == folder / "cat.svg");
    }
}

}  // namespace dapple
