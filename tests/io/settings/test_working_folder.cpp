// The folder that the program works in, removed under its feet.

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/viewer/model/session.h"
#include "app/viewer/model/tile_choices.h"
#include "core/settings/fields.h"
#include "io/files/picture.h"
#include "io/settings/xdg_folders.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

/// Does it in a process of its own, in a folder that is gone. Its exit status; 100 if it throws.
template <class Work>
int status_in_gone_folder(const Work& work) {
    const pid_t child = fork();
    if (child == 0) {
        try {
            const TemporaryFolder folder;
            fs::create_directory(folder / "gone");
            fs::current_path(folder / "gone");
            fs::remove(folder / "gone");
            _exit(work());
        } catch (...) {
            _exit(100);
        }
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("where the working folder is gone, the home folder is offered to save in, or the root") {
    CHECK(working_folder() == fs::current_path());
    CHECK(whole_path("a/../cat.png") == fs::current_path() / "cat.png");
    CHECK(status_in_gone_folder([] {
              setenv("HOME", "/home/cat", 1);
              if (working_folder() != "/home/cat" || folder_of_tiles("") != "/home/cat") return 1;
              unsetenv("HOME");
              if (working_folder() != "/") return 2;
              if (whole_path("cat.png") != "cat.png" || whole_path("/a/../cat.png") != "/cat.png") return 3;
              return 0;
          }) == 0);
}

TEST_CASE("where the working folder is gone, a project with a relative name is a sentence") {
    CHECK(status_in_gone_folder([] {
              Session session(DrawingSettings{}, [] {});
              session.save_project("cat.dapple");
              return session.banner.kind == BannerKind::error && !session.banner.message.empty() ? 0 : 1;
          }) == 0);
}

}  // namespace dapple
