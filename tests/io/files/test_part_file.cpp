#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <ostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "io/files/atomic_file.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

void save(const fs::path& target, const char* text) {
    save_atomically(target, [&](std::ostream& out) { out << text; });
}

// Another dapple that is in the middle of saving, until it is killed.
class Writer {
 public:
    explicit Writer(const fs::path& target) : id_(fork()) {
        if (id_ != 0) return;
        save_atomically(target, [](std::ostream& out) {
            out << "half" << std::flush;
            for (;;) pause();
        });
        _exit(0);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { end(SIGKILL); }
    void end(int signal) {
        if (id_ <= 0) return;
        kill(id_, signal);
        waitpid(std::exchange(id_, -1), nullptr, 0);
    }

 private:
    pid_t id_;
};

// Its part has what was written so far.
bool is_half_written(const fs::path& folder) {
    return std::ranges::any_of(fs::directory_iterator(folder),
                               [](const auto& entry) { return text_of(entry.path()) == "half"; });
}

}  // namespace

TEST_CASE("what a killed save leaves is gone after the next one in that folder, and the old file is whole") {
    const TemporaryFolder folder;
    put_text(folder / "a.txt", "old");
    {
        Writer writer(folder / "a.txt");
        REQUIRE(wait_until([&] { return is_half_written(folder.path()); }));
        writer.end(SIGKILL);
    }
    CHECK(folder.entries() == 2);
    CHECK(text_of(folder / "a.txt") == "old");
    save(folder / "b.txt", "new");
    CHECK(folder.entries() == 2);
    CHECK(text_of(folder / "a.txt") == "old");
    CHECK(text_of(folder / "b.txt") == "new");
}

TEST_CASE("what another dapple is writing stays while it does, and becomes its file") {
    const TemporaryFolder folder;
    signal(SIGTERM, SIG_DFL);  // doctest's would tell of a crash
    const PartFile mine(folder / "mine.txt");
    Writer writer(folder / "a.txt");
    REQUIRE(wait_until([&] { return is_half_written(folder.path()); }));
    save(folder / "b.txt", "new");
    CHECK(folder.entries() == 3);  // theirs, mine and b.txt
    writer.end(SIGTERM);
    CHECK(folder.entries() == 2);  // a forked child removes its own file, not mine
    save(folder / "b.txt", "newer");
    CHECK(folder.entries() == 2);  // mine stays
    CHECK(fs::exists(mine.path()));
}

TEST_CASE("nothing but abandoned parts is tidied up") {
    const TemporaryFolder folder;
    for (const char* name : {".dapple-.part", ".dapple-1a2b3c4d.partly", ".dapple-1A2B3C4D.part", "a.part",
                             ".dapple-1a2b3c4d5.part"})
        put_text(folder / name, "yours");
    put_text(folder / "precious", "yours");
    fs::create_symlink("precious", folder / ".dapple-00000001.part");
    fs::create_directory(folder / ".dapple-00000002.part");
    REQUIRE(mkfifo((folder / ".dapple-00000003.part").c_str(), 0600) == 0);
    const std::size_t before = folder.entries();
    put_text(folder / ".dapple-00000004.part", "abandoned");
    remove_abandoned_parts(folder.path());
    CHECK(folder.entries() == before);
    CHECK_FALSE(fs::exists(folder / ".dapple-00000004.part"));
    remove_abandoned_parts(folder / "missing");
}

TEST_CASE("many savers tidy up beside each other and lose none of their files") {
    const TemporaryFolder folder;
    std::vector<std::jthread> savers;
    for (int s = 0; s < 4; ++s)
        savers.emplace_back([&folder, s] {
            for (int i = 0; i < 50; ++i) save(folder / (std::to_string(s) + ".txt"), "whole");
        });
    savers.clear();
    for (int s = 0; s < 4; ++s) CHECK(text_of(folder / (std::to_string(s) + ".txt")) == "whole");
    CHECK(folder.entries() == 4);
}
