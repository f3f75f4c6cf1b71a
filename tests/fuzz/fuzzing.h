#pragma once
// What a fuzzing command is asked for on its command line, and what it prints.

#include <cstdint>
#include <filesystem>
#include <string>

#include "tests/fuzz/watched_runs.h"

namespace dapple {

struct FuzzOptions {
    std::string kind = {};            // of files: "png", "tile"
    std::filesystem::path seed = {};  // a file that is right
    std::uint64_t runs = 20'000, random = 1;
    double seconds = 1e9;
    std::filesystem::path keep = {};  // a folder for files that ended a process; "": none
};

/// KIND SEED-FILE [--runs N] [--seconds S] [--random N] [--keep FOLDER]. Throws std::runtime_error.
FuzzOptions fuzz_options(int argc, char** argv);

/// The file of a run: the same for the same seed, random number and run.
std::string fuzzed_file(const FuzzOptions& options, const std::string& seed, std::uint64_t run);

/// Runs, prints a line of figures, and keeps the files that ended a process. How many there were.
std::size_t fuzz(const FuzzOptions& options, const std::function<void(const std::string& file)>& read);

}  // namespace dapple
