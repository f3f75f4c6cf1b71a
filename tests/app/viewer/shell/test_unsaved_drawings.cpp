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
    const auto asks = [&] { return KeptDrawings(folder / "unsaved").asks(); };
    CHECK_FALSE(asks());
    fs::path kept;
    {
        KeptDrawings window(folder / "unsaved");
        kept = window.own_file();
        CHECK(window.own_file() == kept);
        put_text(kept, R"({"dapple": 1, "picture": {"file": "../cat.jpg"}})");
        CHECK_FALSE(asks());  // it lives
    }
    REQUIRE(asks());
    CHECK(KeptDrawings(folder / "unsaved").asked() == kept);
    CHECK(picture_of_kept(kept) == "cat.jpg");
}

TEST_CASE("a window that has nothing unsaved any more leaves nothing, and without a folder nothing is kept") {
    const TemporaryFolder folder;
    KeptDrawings window(folder.path());
    put_text(window.own_file(), "{}");
    window.forget();
    CHECK(fs::is_empty(folder.path()));
    CHECK(KeptDrawings().own_file().empty());
    CHECK_FALSE(KeptDrawings().asks());
    put_text(folder / "file", "");
    CHECK_THROWS(KeptDrawings(folder / "file").own_file());
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
