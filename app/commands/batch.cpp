#include "app/commands/batch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "app/commands/render_report.h"
#include "core/failure.h"
#include "core/text/shown_text.h"
#include "io/command_line/options.h"
#include "io/files/atomic_file.h"
#include "io/files/sheet_files.h"
#include "io/progress_line.h"

namespace dapple {

void add_mural_options(CLI::App& app, Sheet& sheets) {
    const auto read_sheets = [&](const std::string& text) {
        const Sheet read = parse_sheets(text);
        sheets.columns = read.columns;
        sheets.rows = read.rows;
    };
    add_text(app, "--sheets", "CxR", read_sheets,
             "Draws all sheets of a mural, each in a file: 3x4 -o mural.svg makes mural-A1.svg to "
             "mural-C4.svg, in 3 columns and 4 rows, and mural-plan.svg, which shows how they join")
        ->group("Page");
    add_length(app, setting::overlap, sheets.overlap_mm)->group("Page");
}

void tell_of_no_share(const WorkShare& share, std::size_t count, const char* things) {
    fmt::print(stderr, "none of the {} {} is in share {} of {}; nothing was drawn\n", count, things,
               share.index + 1, share.of);
}

void render_mural(const RenderOptions& options) {
    const Sheet& sheets = options.drawing.sheets;
    std::vector<RenderOptions> parts;
    std::size_t number = 0;
    for (const Sheet& sheet : all_sheets(sheets)) {
        if (!options.share.has(number++)) continue;
        RenderOptions& part = parts.emplace_back(options);
        part.sheet = sheet;
        part.output = sheet_file(options.output, name_of(sheet));
        part.stats.reset();
    }
    if (parts.empty()) {
        tell_of_no_share(options.share, number, "sheets");
        return;
    }
    PageSize page;
    std::size_t drawn = 0;
    std::vector<NamedFindings> found;
    std::vector<std::string> stats;
    check_stats(options);
    {
        ProgressLine line;
        const auto show = [&](double share) {
            line.show((static_cast<double>(drawn) + share) / static_cast<double>(parts.size()),
                      fmt::format("{} of {} sheets drawn", drawn, parts.size()));
        };
        const auto take = [&](const RenderOptions& part, const Rendered& rendered) {
            page = rendered.whole_page;
            found.push_back({name_of(part.sheet), rendered.findings});
            if (options.stats) stats.push_back(stats_of(part, rendered));
            ++drawn;
        };
        try {
            render_parts(parts, show, take);
        } catch (const std::runtime_error&) {
            save_next(drawn, [] { throw; });
        }
    }
    const bool writes_plan = options.share.index == 0;
    if (writes_plan) save_next(drawn, [&] { save_assembly_plan(options.output, page, sheets); });
    const bool by_pen = options.saving.pen_files && options.drawing.pens.set != PenSet::one;
    const char* const each_pen = by_pen ? ", a file for each pen" : "";
    if (options.share.of > 1) {
        std::vector<std::string> names;
        for (const RenderOptions& part : parts) names.push_back(printable(part.output.native()));
        fmt::print(stderr, "{} of {}: {}{}; {}\n", drawn, sheets_in_words(page, sheets),
                   fmt::join(names, ", "), each_pen,
                   writes_plan ? printable(plan_file(options.output).native()) + " shows how they join"
                               : std::string("the plan is written with share 1"));
    } else {
        fmt::print(stderr, "{}: {}{}\n", sheets_in_words(page, sheets),
                   sheet_files_in_words(options.output, sheets), each_pen);
    }
    if (prints_advice(options))
        for (const std::string& line : findings_among(found)) fmt::print(stderr, "{}\n", line);
    if (options.stats) save_stats(*options.stats, stats_of_all(stats));
}

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
            throw failure("{} and {} would both become {}; draw them into two folders",
                          printable(there->second.native()), printable(picture.native()),
                          printable(output.native()));
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
                    render(one, [&](double share) { progress.report(i, std::min(share, 0.99)); });
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
    if (prints_advice(options)) result.findings = findings_among(found);
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
