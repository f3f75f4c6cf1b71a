#include "app/files/tile_library.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/files/file_ending.h"
#include "app/files/text_file.h"
#include "app/shown_text.h"
#include "dapple_assets_embedded/tile_assets.h"

namespace dapple {
namespace {

struct Entry {
    BuiltInTile tile;
    std::string_view (*text)();
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{
        {{"paper16", "the paper's tile, Appendix A"}, tile_assets::paper16_tile},
        {{"paper20", "the fourth radius of 20 points: the paper prints it, but not the tile"},
         tile_assets::paper20_tile},
        {{"lattice24", "the best radius of 24 points, nearly a lattice"}, tile_assets::lattice24_tile},
        {{"lattice28", "the best radius of 28 points, nearly a lattice"}, tile_assets::lattice28_tile},
        {{"best32", "the best radius of 32 points, no lattice"}, tile_assets::best32_tile},
        {{"lattice36", "the best radius of 36 points, nearly a lattice"}, tile_assets::lattice36_tile},
        {{"aperiodic16", "turned copies: no period, small"}, tile_assets::aperiodic16_tile},
        {{"aperiodic64", "turned copies, 64 points"}, tile_assets::aperiodic64_tile},
        {{"aperiodic256", "turned copies, 256 points"}, tile_assets::aperiodic256_tile},
        {{"aperiodic1024", "turned copies, 1,024 points"}, tile_assets::aperiodic1024_tile},
        {{"aperiodic4096", "turned copies, 4,096 points: the evenest as placed"},
         tile_assets::aperiodic4096_tile},
        {{"kinds4096", "eight kinds of 4,096 points that fit each other: few seams, no period"},
         tile_assets::kinds4096_tile},
    };
    return all;
}

bool looks_like_integers(std::string_view name) {
    return name.find(',') != std::string_view::npos && name.find('/') != std::string_view::npos &&
           name.find_first_not_of("0123456789,/") == std::string_view::npos;
}

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
        throw std::runtime_error(fmt::format(
            "{}: has words but no ranks; dapple tile rank {} -o FILE makes a tile file of them", name, name));
    }
    try {
        return read_tile(text);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: not a tile file, {}", name, error.what()));
    }
}

}  // namespace

const std::vector<BuiltInTile>& built_in_tiles() {
    static const std::vector<BuiltInTile> tiles = [] {
        std::vector<BuiltInTile> list;
        for (const Entry& entry : entries()) list.push_back(entry.tile);
        return list;
    }();
    return tiles;
}

std::span<const char* const> built_in_tile_names() {
    static const std::vector<const char*> names = [] {
        std::vector<const char*> list;
        for (const Entry& entry : entries()) list.push_back(entry.tile.name);
        return list;
    }();
    return names;
}

bool ends_as_tile(const std::filesystem::path& file) {
    return ending_of(file) == kTileEnding;
}

bool is_tile_file_name(const std::string& name) {
    return !looks_like_integers(name) &&
           std::ranges::find(built_in_tile_names(), name) == built_in_tile_names().end();
}

std::string short_tile_name(const std::string& name) {
    return looks_like_integers(name) ? name : printable(std::filesystem::path(name).filename().native());
}

StoredTile load_tile(const std::string& name) {
    for (const Entry& entry : entries())
        if (name == entry.tile.name) return read_tile(entry.text());
    if (looks_like_integers(name)) return ranked(parse_tile_integers(name), RankingMethod::energy);
    std::error_code error;
    if (std::filesystem::exists(name, error)) return read_tile_file(name);
    throw std::runtime_error(
        fmt::format("{}: no such tile or tile file; there are {}, and integers such as 14217,2895/16", name,
                    fmt::join(built_in_tile_names(), ", ")));
}

RankedTile tile_named(const std::string& name, std::optional<RankingMethod> method) {
    StoredTile stored = load_tile(name);
    if (method && *method != stored.method) return {std::move(stored.tile), *method};
    return {std::move(stored.tile), stored.ranking};
}

}  // namespace dapple
