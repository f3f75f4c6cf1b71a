#include <doctest/doctest.h>

#include <optional>

#include "app/viewer/shell/kept_drawings.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

TEST_CASE("what a window kept is found once that window is no more") {
    const TemporaryFolder folder;
    const UnsavedDrawings next(folder / "unsaved");
    CHECK(next.left_behind().empty());
    fs::path kept;
    {
        UnsavedDrawings window(folder / "unsaved");
        kept = window.own_file();
        CHECK(window.own_file() == kept);
        put_text(kept, R"({"dapple": 1, "picture": {"file": "../cat.jpg"}})");
        CHECK(next.left_behind().empty());  // it lives
    }
    REQUIRE(next.left_behind().size() == 1);
    CHECK(next.left_behind()[0] == kept);
    CHECK(picture_of_kept(kept) == "cat.jpg");
    UnsavedDrawings::remove(kept);
    CHECK(next.left_behind().empty());
    CHECK(fs::is_empty(folder / "unsaved"));
}

TEST_CASE("a window that has nothing unsaved any more leaves nothing, and without a folder nothing is kept") {
    const TemporaryFolder folder;
    UnsavedDrawings window(folder.path());
    put_text(window.own_file(), "{}");
    window.forget();
    CHECK(fs::is_empty(folder.path()));
    CHECK(UnsavedDrawings().own_file().empty());
    CHECK(UnsavedDrawings().left_behind().empty());
    put_text(folder / "file", "");
    CHECK_THROWS(UnsavedDrawings(folder / "file").own_file());
}

TEST_CASE("a kept drawing that cannot be read has a name all the same") {
    const TemporaryFolder folder;
    put_text(folder / "broken.dapple", "{");
    CHECK(picture_of_kept(folder / "broken.dapple") == "a drawing");
    put_text(folder / "sample.dapple", R"({"dapple": 1, "picture": null})");
    CHECK(picture_of_kept(folder / "sample.dapple") == "Still life");
}

}  // namespace
}  // namespace dapple
