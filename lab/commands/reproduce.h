#pragma once
// dapple-lab reproduce: every figure and number of the paper, made from scratch.

#include <filesystem>
#include <span>
#include <vector>

#include "lab/reproduce/printed_numbers.h"

namespace CLI {
class App;
}

namespace dapple {

struct ReproduceOptions {
    std::filesystem::path folder;                     // made if it is missing
    std::vector<std::filesystem::path> environments;  // latitude-longitude maps; none: a sky of our own
};

/// Writes index.html, a page that needs nothing beside it, and numbers.json into the folder. Says on standard
/// output how it went. Throws std::runtime_error if a file cannot be read or saved, and as check_equal().
void reproduce(const ReproduceOptions& options);

/// Throws std::runtime_error saying how many numbers differ, and naming `page`, unless none does.
void check_equal(std::span<const ComparedNumber> rows, const std::filesystem::path& page);

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class ReproduceCommand {
 public:
    explicit ReproduceCommand(CLI::App& program);
    ReproduceCommand(const ReproduceCommand&) = delete;
    ReproduceCommand& operator=(const ReproduceCommand&) = delete;

 private:
    ReproduceOptions options_;
};

}  // namespace dapple
