// Files that pasted text names, and the folders that the desktop knows.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/viewer/model/desktop_folders.h"
#include "app/viewer/model/pasted_files.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace fs = std::filesystem;

TEST_CASE("a pasted text names files as file managers and shells write them") {
    const TemporaryFolder folder;
    const fs::path plain = folder / "cat.jpg", odd = folder / "a b%\xc3\xa4.png";
    for (const fs::path& file : {plain, odd}) std::ofstream(file) << "x";
    const auto files = [&](const std::string& text) { return pasted_files(text, folder.path()); };
    const std::string at = folder.path().string();
    CHECK(files(plain.string()) == std::vector{plain});
    CHECK(files("  '" + plain.string() + "' \r\n") == std::vector{plain});
    CHECK(files("~/cat.jpg") == std::vector{plain});
    CHECK(files("file://" + at + "/a%20b%25%C3%a4.png") == std::vector{odd});
    CHECK(files("copy\nfile://localhost" + at + "/cat.jpg\nfile:" + at + "/a%20b%25%c3%a4.png") ==
          std::vector{plain, odd});
    for (const std::string& text :
         {std::string(), std::string("cat.jpg"), at, at + "/none.jpg", "file://elsewhere" + at + "/cat.jpg",
          std::string("%"), std::string("file://")})
        CHECK(files(text).empty());
}

TEST_CASE("the desktop's folders are those there are, each once") {
    const TemporaryFolder home;
    const fs::path config = home / ".config";
    for (const char* name : {"Pictures", "My work", ".config/gtk-3.0"}) fs::create_directories(home / name);
    std::ofstream(config / "user-dirs.dirs")
        << "# comment\nXDG_DOWNLOAD_DIR=\"$HOME/Gone\"\n"
           "XDG_PICTURES_DIR=\"$HOME/Pictures\"\nXDG_DESKTOP_DIR=\"$HOME/\"\n";
    std::ofstream(config / "gtk-3.0/bookmarks")
        << "file://" << home.path().string() << "/My%20work Work\nsftp://x/y\nfile://" << home.path().string()
        << "/Pictures\n";
    CHECK(desktop_folders(home.path(), config) ==
          std::vector<fs::path>{home.path(), home / "Pictures", home / "My work"});
}

}  // namespace dapple
