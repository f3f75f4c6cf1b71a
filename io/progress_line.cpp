#include "io/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "core/text/shown_text.h"

namespace dapple {
namespace {

constexpr int kBarWidth = 24;

std::string in_words(double seconds) {
    if (seconds < 90) return fmt::format("about {:.0f} s left", std::max(seconds, 1.0));
    if (seconds < 5400) return fmt::format("about {:.0f} min left", seconds / 60);
    return fmt::format("about {:.1f} h left", seconds / 3600);
}

}  // namespace

bool on_terminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

ProgressLine::ProgressLine() : terminal_(on_terminal()) {}

ProgressLine::~ProgressLine() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::restart(double fraction) {
    start_ = Clock::now();
    start_fraction_ = fraction;
    last_ = {};
}

void ProgressLine::show(double fraction, std::string_view text, std::string_view piece) {
    const auto now = Clock::now();
    if (!terminal_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double done = fraction - start_fraction_;
    const int filled = static_cast<int>(kBarWidth * std::clamp(fraction, 0.0, 1.0));
    std::string left;
    if (done > 0 && elapsed > 0.5)
        left = fmt::format("{}{}{}, ", piece, piece.empty() ? "" : ": ",
                           in_words(elapsed / done * (1 - fraction)));
    const std::string line =
        fmt::format("\r[{}{}] {:>3.0f} %  {}{}\033[K", std::string(filled, '#'),
                    std::string(kBarWidth - filled, '-'), 100 * fraction, left, printable(text));
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace dapple
