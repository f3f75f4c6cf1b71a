#include "io/files/tile_library.h"

#include <fmt/ranges.h>

#include <stdexcept>

#include "core/failure.h"
#include "core/text/shown_text.h"

namespace dapple {
namespace {

// Whether it is a rule with words, which have no ranks yet.
bool is_words_text(const std::string& text) {
    try {
        return read_words(text).size() > 0;
    } catch (const std::runtime_error&) {
        return false;
    }
}

StoredTile read_tile_file(const std::string& name) {
    const std::string text = text_of_file(name, kTileFile);
    if (!is_tile_text(text) && is_words_text(text)) {
        throw failure("{}: has words but no ranks; dapple-lab tile rank {} -o FILE makes a tile file of them",
                      name, name);
    }
    try {
        return read_tile(text);
    } catch (const std::runtime_error& error) {
        throw failure("{}: not a tile file, {}", name, error.what());
    }
}

}  // namespace

bool ends_as_tile(const std::filesystem::path& file) {
    return ending_of(file) == kTileEnding;
}

std::string short_tile_name(const std::string& name) {
    return looks_like_tile_integers(name) ? name : printable(std::filesystem::path(name).filename().native());
}

StoredTile load_tile(const std::string& name) {
    if (std::optional<StoredTile> known = tile_called(name)) return *std::move(known);
    std::error_code error;
    if (std::filesystem::exists(name, error)) return read_tile_file(name);
    throw failure("{}: no such tile or tile file; there are {}, and integers such as 14217,2895/16", name,
                  fmt::join(built_in_tile_names(), ", "));
}

RankedTile tile_named(const std::string& name, std::optional<RankingMethod> method) {
    return ranked_tile(load_tile(name), method);
}

}  // namespace dapple
