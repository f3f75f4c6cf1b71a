#include "core/tile/built_in_tiles.h"

#include <algorithm>

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

std::optional<StoredTile> built_in_tile(std::string_view name) {
    for (const Entry& entry : entries())
        if (name == entry.tile.name) return read_tile(entry.text());
    return std::nullopt;
}

bool looks_like_tile_integers(std::string_view name) {
    return name.find(',') != std::string_view::npos && name.find('/') != std::string_view::npos &&
           name.find_first_not_of("0123456789,/") == std::string_view::npos;
}

bool is_tile_file_name(std::string_view name) {
    return !looks_like_tile_integers(name) &&
           std::ranges::find(built_in_tile_names(), name) == built_in_tile_names().end();
}

}  // namespace dapple
