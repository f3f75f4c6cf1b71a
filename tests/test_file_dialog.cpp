#include <doctest/doctest.h>

#include <fstream>

#include "app/viewer/panels/file_dialog.h"
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

    void show(FileDialog::Purpose purpose, const fs::path& start) {
        ImGui::GetIO().DisplaySize = {900, 700};
        dialog.show(purpose, start);
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
    f.show(FileDialog::Purpose::open_picture, folder.root.path());
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
    f.show(FileDialog::Purpose::open_picture, folder.root.path());
    f.ui.click("Cancel");
    CHECK_FALSE(f.chosen);
    CHECK_FALSE(f.dialog.is_open());
}

TEST_CASE("saving fills the name in, and the format row changes its ending") {
    Folder folder;
    DialogUi f;
    f.show(FileDialog::Purpose::save_drawing, folder.root.path() / "cat.svg");
    f.ui.click("CSV");
    f.ui.click("Accept");
    REQUIRE(f.chosen);
    CHECK(*f.chosen == folder.root.path() / "cat.csv");
}

TEST_CASE("a folder that is not there, or an ending that is unknown, is refused while the dialog stays") {
    Folder folder;
    DialogUi f;
    f.show(FileDialog::Purpose::save_drawing, folder.root.path() / "missing" / "cat.svg");
    f.ui.click("Accept");
    CHECK_FALSE(f.chosen);
    CHECK(f.dialog.is_open());
    f.dialog.show(FileDialog::Purpose::save_drawing, folder.root.path() / "cat.doc");
    f.ui.frame();
    f.ui.click("Accept");
    CHECK_FALSE(f.chosen);
}

}  // namespace dapple
