// Programs of the desktop's that the window asks: dialogs and the clipboard.

#include <doctest/doctest.h>

#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/viewer/desktop/desktop_programs.h"
#include "app/viewer/desktop/pasted_picture.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

/// A PATH of programs that a test writes; the old one comes back.
class DesktopPath {
 public:
    DesktopPath() {
        ::setenv("PATH", folder_.path().c_str(), 1);
        ::unsetenv("WAYLAND_DISPLAY");
        ::unsetenv("XDG_CURRENT_DESKTOP");
    }
    DesktopPath(const DesktopPath&) = delete;
    DesktopPath& operator=(const DesktopPath&) = delete;
    ~DesktopPath() { ::setenv("PATH", before_.c_str(), 1); }

    void program(const std::string& name, const std::string& commands) const {
        std::ofstream(folder_ / name) << "#!/bin/sh\nPATH=/usr/bin:/bin\n" << commands << "\n";
        fs::permissions(folder_ / name, fs::perms::owner_all);
    }
    fs::path operator/(const std::string& name) const { return folder_ / name; }

 private:
    std::string before_ = std::getenv("PATH");
    TemporaryFolder folder_;
};

std::string paste_trouble(const DesktopPath& path) {
    try {
        save_pasted_picture(path / "pasted", {});
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the desktop's dialog is asked for pictures in a folder, and its answer is the file") {
    const DesktopPath path;
    const OpenQuestion question{"Open a picture", {".png", ".jpg"}, path / ""};
    CHECK_FALSE(has_desktop_dialog());
    path.program("zenity", "for word; do echo \"$word\"; done > " + (path / "asked").string() +
                               "\necho '/pictures/a cat.png'");
    CHECK(has_desktop_dialog());
    CHECK(ask_desktop(question, {}) == fs::path("/pictures/a cat.png"));
    CHECK(text_of(path / "asked") ==
          "--file-selection\n--title=Open a picture\n--filename=" + (path / "").string() +
              "\n--file-filter=Open a picture | *.png *.PNG *.jpg *.JPG\n"
              "--file-filter=All files | *\n");
    path.program("zenity", "exit 1");
    CHECK_FALSE(ask_desktop(question, {}));
    path.program("zenity", "exit 255");
    CHECK_THROWS_WITH(ask_desktop(question, {}),
                      "zenity could not show its dialog; choose Dapple's dialog in the preferences");
    path.program("kdialog", "echo /kde.png");
    ::setenv("XDG_CURRENT_DESKTOP", "KDE", 1);
    CHECK(ask_desktop(question, {}) == fs::path("/kde.png"));
    ::unsetenv("XDG_CURRENT_DESKTOP");
}

TEST_CASE("a program that does not end is ended: when it is stopped, and when its time is over") {
    const DesktopPath path;
    path.program("zenity", "exec sleep 60");
    const auto begin = std::chrono::steady_clock::now();
    std::stop_source stop;
    std::jthread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop.request_stop();
    });
    CHECK_FALSE(output_of({"zenity"}, {}, stop.get_token()));
    CHECK_THROWS_WITH(output_of({"zenity"}, {.longest = std::chrono::seconds(0)}),
                      "zenity did not answer and was ended");
    path.program("loud", "exec cat /dev/zero");
    CHECK_THROWS_WITH(output_of({"loud"}, {.most_bytes = 1000}),
                      "loud gave more than can be taken and was stopped");
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(30));
}

TEST_CASE("a picture on the clipboard becomes a file, PNG before others") {
    const DesktopPath path;
    CHECK(paste_trouble(path).find("install it, or save the picture") != std::string::npos);
    path.program("xclip",
                 "case \"$*\" in\n*TARGETS) printf 'UTF8_STRING\\nimage/jpeg\\nimage/png\\n';;\n"
                 "*'-t image/png') printf 'png';;\n*) exit 1;;\nesac");
    const auto first = save_pasted_picture(path / "pasted", {}),
               second = save_pasted_picture(path / "pasted", {});
    REQUIRE(first);
    REQUIRE(second);
    CHECK(*first != *second);
    CHECK(first->extension() == ".png");
    CHECK(text_of(*first) == "png");
    path.program("xclip", "echo UTF8_STRING");
    CHECK(paste_trouble(path).find("The clipboard has neither a picture nor a file's path") == 0);
    path.program("xclip", "exit 1");  // as it does of an empty clipboard
    CHECK(paste_trouble(path).find("The clipboard has neither a picture nor a file's path") == 0);
    path.program("xclip", "case \"$*\" in *TARGETS) echo image/png;; esac");
    CHECK(paste_trouble(path).find("could not be read from xclip") != std::string::npos);
    // On Wayland the other one is asked, where it is there.
    path.program("wl-paste", "case \"$*\" in *list*) echo image/webp;; *) printf 'webp';; esac");
    ::setenv("WAYLAND_DISPLAY", "wayland-0", 1);
    CHECK(save_pasted_picture(path / "pasted", {}).value().extension() == ".webp");
    ::unsetenv("WAYLAND_DISPLAY");
}

TEST_CASE(
    "a picture is copied by the program of the desktop's that is there, and what fails is said in a "
    "sentence") {
    const DesktopPath path;
    put_text(path / "drawing.png", "png");
    const auto trouble = [&] {
        try {
            return copy_picture(path / "drawing.png", {}) ? std::string() : "stopped";
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
    };
    CHECK(trouble().find("Copying a picture needs xclip") == 0);
    // It goes on to hand the picture out, as xclip does.
    path.program("xclip", "echo \"$1 $2 $3 $4\" >'" + (path / "asked").string() + "'; cat \"$5\" >'" +
                              (path / "copied").string() + "'; sleep 600 & echo $! >'" +
                              (path / "holder").string() + "'");
    CHECK(trouble().empty());
    ::kill(std::stoi(text_of(path / "holder")), SIGKILL);
    CHECK(text_of(path / "asked") == "-selection clipboard -t image/png\n");
    CHECK(text_of(path / "copied") == "png");
    path.program("wl-copy", "cat >'" + (path / "copied").string() + "'; echo \"$*\" >>'" +
                                (path / "copied").string() + "'");
    ::setenv("WAYLAND_DISPLAY", "wayland-0", 1);
    CHECK(trouble().empty());
    ::unsetenv("WAYLAND_DISPLAY");
    CHECK(text_of(path / "copied") == "png--type image/png\n");
    path.program("xclip", "exit 1");
    CHECK(trouble() == "The picture could not be copied: no clipboard accepts it");
}

}  // namespace dapple
