#pragma once
// dapple mask: a threshold mask for screening, as pictures.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/drawing/settings.h"
#include "core/screening/void_and_cluster.h"

namespace CLI {
class App;
}

namespace dapple {

/// What orders a mask's pixels.
enum class MaskOrder { clusters, tile };
constexpr auto names_of(MaskOrder) {
    return names("clusters", "tile");
}

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class MaskCommand {
 public:
    explicit MaskCommand(CLI::App& program);
    MaskCommand(const MaskCommand&) = delete;
    MaskCommand& operator=(const MaskCommand&) = delete;

 private:
    void check(const CLI::App& command) const;
    void save() const;

    ThresholdSize size_;
    MaskOrder order_ = MaskOrder::clusters;
    VoidAndClusterOptions clusters_;
    std::string tile_ = kDefaultTile;
    int bits_ = 8;
    double gain_ = 0;
    std::filesystem::path output_;
    std::optional<std::filesystem::path> screens_;  // a picture
};

}  // namespace dapple
