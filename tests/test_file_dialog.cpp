#include <doctest/doctest.h>

#include <fstream>

#include "app/viewer/shell/file_dialog.h"
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
    HeadlessUi ui{[this] {
        if (auto path = dialog.draw()) chosen = path;
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
                                  .own_file = own_file});
        for (int i = 0; i < 4; ++i) ui.frame();
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
    f.ui.click("inner.tif");
    CHECK_FALSE(f.chosen);
    f.ui.click("Accept");
    REQUIRE(f.chosen);
    CHECK(*f.chosen == folder.root.path() / "b folder" / "inner.tif");
    CHECK_FALSE(f.dialog.is_open());
}

TEST_CASE("Cancel chooses nothing") {
    Folder folder;
    DialogUi f;
    f.open(folder.root.path());
    f.ui.click("Cancel");
    CHECK_FALSE(f.chosen);
    CHECK_FALSE(f.dialog.is_open());
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
    f.ui.click("Keep");
    CHECK_FALSE(f.chosen);
    CHECK(f.dialog.is_open());
    f.ui.click("Accept");
    f.ui.click("Replace");
    CHECK(f.chosen == there);
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

TEST_CASE("Enter chooses the file that was clicked") {
    Folder folder;
    DialogUi f;
    f.open(folder.root.path());
    f.ui.click("ant.png");
    CHECK_FALSE(f.chosen);
    f.ui.key(Key::enter);
    CHECK(f.chosen == folder.root.path() / "ant.png");
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

}  // namespace dapple
