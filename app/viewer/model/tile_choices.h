#pragma once
// The tiles that a window offers: the built-in ones, and those that the person brought along.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace dapple {

class TileChoices {
 public:
    /// Also the tile that the window opens with, whatever it is.
    explicit TileChoices(const std::string& first);

    /// Adds a tile file and returns its name for tile_named(). If it is not one nothing is added: throws
    /// std::runtime_error as load_tile() does.
    std::string open(const std::filesystem::path& file);

    /// Names for tile_named(), the built-in ones first.
    std::span<const std::string> names() const { return names_; }

 private:
    void add(const std::string& name);

    std::vector<std::string> names_;
};

/// Where to look for another tile file: beside the one in use, if that is a file.
std::filesystem::path folder_of_tiles(const std::string& tile_in_use);

}  // namespace dapple
