#include "app/viewer/desktop/desktop_programs.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/descriptor.h"

extern char** environ;

namespace dapple {

namespace {

using ChildClock = std::chrono::steady_clock;

std::runtime_error child_error(const std::string& program, const std::string& what) {
    return std::runtime_error(program + " " + what);
}

struct StartedProgram : Child {
    explicit StartedProgram(const std::vector<std::string>& words) {
        auto ends = own_pipe();
        if (!ends)
            throw child_error(words[0], "cannot be started: " + std::generic_category().message(errno));
        output = std::move((*ends)[0]);
        const Descriptor input = std::move((*ends)[1]);
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, input.get(), STDOUT_FILENO);
        pid_t started = -1;  // of a failure nothing is to be ended
        const int error =
            ::posix_spawnp(&started, arguments[0], &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0)
            throw child_error(words[0], "cannot be started: " + std::generic_category().message(error));
        id = started;
    }
};

}  // namespace

bool is_in_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && ::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

std::optional<ChildOutput> output_of(const std::vector<std::string>& words, const ChildLimits& limits,
                                     const std::stop_token& stop) {
    constexpr int kLookEvery = 50;  // ms: for being stopped, and for the time
    StartedProgram child(words);
    const auto begin = ChildClock::now();
    ChildOutput output;
    std::array<char, 1 << 16> buffer;
    for (;;) {
        if (stop.stop_requested()) return std::nullopt;
        if (limits.longest && ChildClock::now() - begin > *limits.longest)
            throw child_error(words[0], "did not answer and was ended");
        pollfd waits{child.output.get(), POLLIN, 0};
        if (::poll(&waits, 1, kLookEvery) <= 0) continue;
        const ssize_t got = ::read(child.output.get(), buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        output.bytes.append(buffer.data(), static_cast<std::size_t>(got));
        if (output.bytes.size() > limits.most_bytes)
            throw child_error(words[0], "gave more than can be taken and was stopped");
    }
    const int status = child.wait();
    output.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return output;
}

namespace {

namespace fs = std::filesystem;

// Each ending as it is and in capitals: both programs tell them apart.
std::string patterns(const std::vector<std::string>& endings) {
    std::string all;
    for (const std::string& ending : endings) {
        std::string capitals = ending;
        for (char& letter : capitals)
            letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
        all += (all.empty() ? "*" : " *") + ending + " *" + capitals;
    }
    return all;
}

// KDE's own where both are there and the desktop is KDE's.
bool takes_kdialog() {
    const char* const desktop = std::getenv("XDG_CURRENT_DESKTOP");
    const bool is_kde = desktop && std::string_view(desktop).find("KDE") != std::string_view::npos;
    return is_in_path("kdialog") && (is_kde || !is_in_path("zenity"));
}

std::vector<std::string> dialog_words(const OpenQuestion& question) {
    std::error_code ignored;
    const fs::path whole = fs::absolute(question.start, ignored);
    const fs::path folder = (fs::is_directory(whole, ignored) ? whole : whole.parent_path()) / "";
    if (takes_kdialog()) {
        std::vector<std::string> words{"kdialog", "--title", question.title, "--getopenfilename",
                                       folder.string()};
        if (!question.endings.empty()) words.push_back(patterns(question.endings));
        return words;
    }
    std::vector<std::string> words{"zenity", "--file-selection", "--title=" + question.title,
                                   "--filename=" + folder.string()};
    if (!question.endings.empty()) {
        words.push_back("--file-filter=" + question.title + " | " + patterns(question.endings));
        words.emplace_back("--file-filter=All files | *");
    }
    return words;
}

}  // namespace

bool has_desktop_dialog() {
    return is_in_path("zenity") || is_in_path("kdialog");
}

std::optional<fs::path> ask_desktop(const OpenQuestion& question, const std::stop_token& stop) {
    const std::vector<std::string> words = dialog_words(question);
    auto answer = output_of(words, {}, stop);
    if (!answer) return std::nullopt;
    constexpr int kCancelled = 1;
    std::string& path = answer->bytes;
    if (path.ends_with('\n')) path.pop_back();
    if (answer->status == kCancelled || (answer->status == 0 && path.empty())) return std::nullopt;
    if (answer->status != 0 || !fs::path(path).is_absolute())
        throw std::runtime_error(words[0] +
                                 " could not show its dialog; choose Dapple's dialog in the preferences");
    return path;
}

void show_in_folder(const fs::path& file) {
    std::error_code ignored;
    output_of({"sh", "-c", "xdg-open \"$1\" >/dev/null 2>&1 &", "sh",
               fs::absolute(file, ignored).parent_path().string()},
              {});
}

}  // namespace dapple
