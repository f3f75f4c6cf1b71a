#pragma once
// dapple-lab volume: even dots in space, of a density or of a point cloud.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace CLI {
class App;
}

namespace dapple {

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class VolumeCommand {
 public:
    explicit VolumeCommand(CLI::App& program);
    VolumeCommand(const VolumeCommand&) = delete;
    VolumeCommand& operator=(const VolumeCommand&) = delete;

 private:
    void run(const CLI::App& command) const;

    std::vector<std::filesystem::path> inputs_;
    std::uint64_t dots_ = 10'000;
    int relax_ = 20;
    bool invert_ = false;
    std::filesystem::path output_;
    std::optional<std::filesystem::path> film_;
};

}  // namespace dapple
