#include "lab/commands/save_tile.h"

#include <fmt/format.h>

#include <ostream>

#include "io/files/atomic_file.h"
#include "lab/search/tile_marks.h"

namespace dapple {

void save_tile(const std::filesystem::path& file, const StoredTile& tile,
               const std::vector<std::string>& more) {
    std::vector<std::string> comments{headline(tile.tile)};
    for (const TileMark& mark : in_words(marks_of(tile.tile, tile.ranking)))
        comments.push_back(fmt::format("{}: {} ({})", mark.name, mark.value, mark.meaning));
    comments.insert(comments.end(), more.begin(), more.end());
    const std::string text = write_tile(tile, comments);
    save_atomically(file, [&](std::ostream& out) { out << text; });
}

}  // namespace dapple
