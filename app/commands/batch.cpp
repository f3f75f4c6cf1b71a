#include "app/commands/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "app/commands/render_report.h"
#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/progress_line.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr int kMostUsualJobs = 4;

// How far all pictures together have come, reported from several threads.
class BatchProgress {
 public:
    explicit BatchProgress(std::size_t pictures) : shares_(pictures, 0.0) {}

    void report(std::size_t picture, double share) {
        const std::lock_guard lock(mutex_);
        all_ += share - shares_[picture];
        shares_[picture] = share;
        done_ += share == 1;
        const auto count = static_cast<double>(shares_.size());
        line_.show(all_ / count, fmt::format("{} of {} pictures drawn", done_, shares_.size()));
    }

 private:
    std::mutex mutex_;
    std::vector<double> shares_;
    double all_ = 0;
    std::size_t done_ = 0;
    ProgressLine line_;
};

}  // namespace

bool is_output_folder(const fs::path& output) {
    std::error_code ignored;
    return (!output.empty() && !output.has_filename()) ||
           (!output.has_extension() && fs::is_directory(output, ignored));
}

fs::path output_in(const fs::path& folder, const fs::path& picture, DrawingFormat format) {
    const char* const ending = kDrawingFormats[static_cast<std::size_t>(format)].ending;
    return folder / picture.filename().stem().concat(ending);
}

void check_names_differ(const std::vector<fs::path>& pictures, const fs::path& folder, DrawingFormat format) {
    std::map<fs::path, fs::path> by_output;
    for (const fs::path& picture : pictures) {
        const fs::path output = output_in(folder, picture, format);
        const auto [there, is_new] = by_output.emplace(output, picture);
        if (!is_new) {
            throw std::runtime_error(fmt::format("{} and {} would both become {}; draw them into two folders",
                                                 printable(there->second.native()),
                                                 printable(picture.native()), printable(output.native())));
        }
    }
}

BatchResult render_batch(const RenderOptions& options, const std::vector<fs::path>& pictures, int jobs) {
    const fs::path& folder = options.output;
    const DrawingFormat format = options.format.value_or(DrawingFormat::svg);
    make_folder(folder);
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    const int usual = std::clamp(cores / 2, 1, kMostUsualJobs);
    const std::size_t at_once = std::min<std::size_t>(jobs > 0 ? jobs : usual, pictures.size());

    std::vector<std::optional<std::string>> reasons(pictures.size());
    std::vector<NamedFindings> found(pictures.size());
    std::vector<std::string> stats(pictures.size());
    check_stats(options);
    BatchProgress progress(pictures.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < pictures.size(); i = next++) {
            try {
                RenderOptions one = options;
                one.image = pictures[i];
                one.output = output_in(folder, pictures[i], format);
                one.stats.reset();
                const Rendered rendered =
                    render(one, {[&](double share) { progress.report(i, std::min(share, 0.99)); }});
                found[i] = {printable(one.output.filename().native()), rendered.findings};
                if (options.stats) stats[i] = stats_of(one, rendered);
            } catch (const std::exception& failure) {
                reasons[i] = failure.what();
            }
            progress.report(i, 1);
        }
    };
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 1; i < at_once; ++i) threads.emplace_back(work);
        work();
    }
    BatchResult result;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (reasons[i])
            result.failures.push_back({pictures[i], *reasons[i]});
        else
            ++result.drawn;
    }
    result.findings = findings_among(found);
    std::erase(stats, "");  // of those that failed
    if (options.stats) save_stats(*options.stats, stats_of_all(stats));
    return result;
}

std::string batch_summary(const BatchResult& result, const fs::path& folder) {
    const auto count = [](std::size_t n, const char* what) {
        return fmt::format("{} {}{}", grouped(n), what, n == 1 ? "" : "s");
    };
    std::string text = fmt::format("{} in {}", count(result.drawn, "drawing"), printable(folder.native()));
    if (!result.failures.empty())
        text += fmt::format("; {} failed:", count(result.failures.size(), "picture"));
    for (const BatchResult::Failure& failure : result.failures) {
        // Most reasons begin with the file's name.
        const std::string name = printable(failure.picture.native());
        text += failure.why.starts_with(name) ? "\n  " + failure.why
                                              : fmt::format("\n  {}: {}", name, failure.why);
    }
    for (const std::string& line : result.findings) text += "\n  " + line;
    return text;
}

}  // namespace dapple
