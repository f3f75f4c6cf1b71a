// What becomes of files that were dropped on the window or pasted.

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "app/viewer/shell/asking.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

/// Pictures called both.png hold settings.
struct AskedFiles {
    FileQuestion question;
    std::optional<FileQuestion::Answer> answer;
    FileQuestion::IsBoth is_both{[](const fs::path& file) { return file.filename() == "both.png"; }};
    HeadlessUi ui{[this] {
        if (const auto now = question.draw(is_both)) answer = now;
    }};

    void drop(std::vector<fs::path> files) {
        ImGui::GetIO().DisplaySize = {900, 700};
        question.ask(std::move(files), is_both);
        for (int i = 0; i < 4; ++i) ui.frame();
    }
    void expect(const fs::path& file, bool as_picture) {
        REQUIRE(answer);
        CHECK(answer->file == file);
        CHECK(answer->as_picture == as_picture);
        answer.reset();
        for (int i = 0; i < 4; ++i) ui.frame();
        CHECK_FALSE(answer);
        CHECK_FALSE(ui.has("Use its settings"));
    }
};

}  // namespace

TEST_CASE("one file that is dropped is opened, without a question") {
    AskedFiles files;
    files.drop({});
    CHECK_FALSE(files.answer);
    files.drop({"/pictures/cat.png"});
    files.expect("/pictures/cat.png", false);
}

TEST_CASE("of several files none is opened before one is chosen") {
    AskedFiles files;
    const std::vector<fs::path> dropped{"/pictures/cat.png", "/pictures/dog.png", "/other/dog.png"};
    files.drop(dropped);
    CHECK_FALSE(files.answer);
    files.ui.click("Open cat.png");
    files.expect("/pictures/cat.png", false);
    // By keyboard.
    files.drop(dropped);
    files.ui.key(Key::tab);
    files.ui.key(Key::down);
    files.ui.key(Key::down);
    files.ui.key(Key::enter);
    files.expect("/other/dog.png", false);
    files.drop(dropped);
    files.ui.key(Key::escape);
    files.ui.frame();
    CHECK_FALSE(files.answer);
    CHECK_FALSE(files.ui.has("Open cat.png"));
}

TEST_CASE("hundreds of files that are dropped at once stay in the window") {
    AskedFiles files;
    files.drop(std::vector<fs::path>(500, "/pictures/cat.png"));
    REQUIRE(files.ui.has("Open cat.png"));
    files.ui.key(Key::tab);
    CHECK(files.ui.place(kRowWithKeys).min.y > 0);
    CHECK(files.ui.place(kRowWithKeys).max.y < 700);
}

TEST_CASE("a picture that holds settings is opened as what the person says") {
    AskedFiles files;
    const fs::path both = "/pictures/both.png";
    files.drop({both});
    CHECK_FALSE(files.answer);
    files.ui.click("Use its settings");
    files.expect(both, false);
    files.drop({both});
    files.ui.click("Open as a picture");
    files.expect(both, true);
    files.drop({both, "/pictures/cat.png"});
    files.ui.click("Open both.png");
    files.ui.frame();
    files.ui.frame();
    CHECK_FALSE(files.answer);
    files.ui.key(Key::tab);
    files.ui.key(Key::tab);
    files.ui.key(Key::enter);
    files.expect(both, true);
    files.drop({both});
    files.ui.key(Key::escape);
    files.ui.frame();
    CHECK_FALSE(files.answer);
    CHECK_FALSE(files.ui.has("Use its settings"));
}

}  // namespace dapple
