#include "app/viewer/panels/method_panels.h"

#include <algorithm>
#include <vector>

#include "app/viewer/widgets/widgets.h"
#include "core/drawing/settings.h"
#include "io/files/tile_library.h"

namespace dapple {

bool tile_row(const char* label, std::string& tile, const TileList& list, const char* tip) {
    std::vector<std::string> tiles(list.names.begin(), list.names.end());
    auto chosen = static_cast<int>(std::ranges::find(tiles, tile) - tiles.begin());
    if (chosen == static_cast<int>(tiles.size())) tiles.push_back(tile);

    std::vector<std::string> words;
    for (const std::string& name : tiles) {
        const std::string shown = short_tile_name(name);
        const bool alone = std::ranges::count(tiles, shown, short_tile_name) == 1;
        words.push_back(alone ? shown : name);
    }
    if (list.open_file) words.emplace_back("From a file...");
    std::vector<const char*> entries;
    for (const std::string& word : words) entries.push_back(word.c_str());

    const auto usual = std::ranges::find(tiles, kDefaultTile);
    const ListLook look{.by_arrows = static_cast<int>(tiles.size()),
                        .usual = usual == tiles.end() ? -1 : static_cast<int>(usual - tiles.begin())};
    if (!choice_row(label, chosen, entries, tip, look)) return false;
    if (chosen == static_cast<int>(tiles.size())) {
        list.open_file();
        return false;
    }
    tile = tiles[static_cast<std::size_t>(chosen)];
    return true;
}

}  // namespace dapple
