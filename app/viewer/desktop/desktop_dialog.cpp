#include "app/viewer/desktop/desktop_dialog.h"

#include <cctype>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "io/files/child_output.h"

namespace dapple {
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
