#include "tests/fuzz/fuzzing.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "core/text/number_words.h"
#include "tests/fuzz/mutations.h"

namespace dapple {
namespace {

template <class Number>
Number number(const std::string& text) {
    const std::optional<Number> read = number_of<Number>(text);
    if (!read) throw std::runtime_error(text + ": not a number");
    return *read;
}

}  // namespace

FuzzOptions fuzz_options(int argc, char** argv) {
    if (argc < 3 || argc % 2 == 0)
        throw std::runtime_error(
            "usage: KIND SEED-FILE [--runs N] [--seconds S] [--random N] [--keep FOLDER]");
    FuzzOptions options{.kind = argv[1], .seed = argv[2]};
    for (int i = 3; i + 1 < argc; i += 2) {
        const std::string_view name = argv[i];
        if (name == "--runs")
            options.runs = number<std::uint64_t>(argv[i + 1]);
        else if (name == "--seconds")
            options.seconds = number<double>(argv[i + 1]);
        else if (name == "--random")
            options.random = number<std::uint64_t>(argv[i + 1]);
        else if (name == "--keep")
            options.keep = argv[i + 1];
        else
            throw std::runtime_error("no such option: " + std::string(name));
    }
    return options;
}

std::string fuzzed_file(const FuzzOptions& options, const std::string& seed, std::uint64_t run) {
    std::seed_seq sequence{options.random, run};
    std::mt19937_64 random(sequence);
    return mutated(seed, random);
}

std::size_t fuzz(const FuzzOptions& options, const std::function<void(const std::string& file)>& read) {
    std::ifstream file(options.seed, std::ios::binary);
    const std::string seed{std::istreambuf_iterator<char>(file), {}};
    if (seed.empty()) throw std::runtime_error(options.seed.string() + ": there is nothing in it");
    const WatchedResult result =
        watched_runs({.runs = options.runs, .seconds = options.seconds},
                     [&](std::uint64_t run) { read(fuzzed_file(options, seed, run)); });
    std::printf("%-10s %7llu files, %3zu ended their process, longest %.2f s, most memory %llu MB\n",
                options.kind.c_str(), static_cast<unsigned long long>(result.runs), result.ended.size(),
                result.longest_seconds, static_cast<unsigned long long>(result.most_memory >> 20));
    for (const WatchedResult::Ended& ended : result.ended) {
        std::printf("    run %llu: %s\n", static_cast<unsigned long long>(ended.run), ended.how.c_str());
        if (options.keep.empty()) continue;
        std::filesystem::create_directories(options.keep);
        std::ofstream(options.keep / (options.kind + "." + std::to_string(ended.run)), std::ios::binary)
            << fuzzed_file(options, seed, ended.run);
    }
    return result.ended.size();
}

}  // namespace dapple
