#pragma once
// dapple-lab compare: this program and the methods that came before it, measured alike.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace dapple {

struct CompareOptions {
    std::vector<std::filesystem::path> pictures;  // none: the built-in still life
    bool icons = false;                           // these too
    std::vector<std::string> methods;             // by name; none: all
    std::vector<std::size_t> dots{65'536};
    std::size_t picture_dots = 10'000;
    std::size_t most = 10'000'000;  // dots up to which time is measured
    double seconds = 20;            // for one drawing
    std::uint64_t seed = 1;
    std::optional<std::filesystem::path> json, page;
};

/// Measures, saves, and prints tables on standard output. After Ctrl+C the tables have the methods that were
/// finished, and nothing is saved. Throws std::runtime_error with one sentence.
void compare(const CompareOptions& options);

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class CompareCommand {
 public:
    explicit CompareCommand(CLI::App& program);
    CompareCommand(const CompareCommand&) = delete;
    CompareCommand& operator=(const CompareCommand&) = delete;

 private:
    CompareOptions options_;
};

}  // namespace dapple
