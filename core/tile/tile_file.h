#pragma once
// Ranked tiles as short text, and back.
//
//      dapple tile 1
//      # 16 points, balanced: 4 in each quadrant
//      rule 0 0 0 0
//      points 16
//      words
//      0012032123123313                  cycles and tails as make_tile() takes them, one a line
//      ranking energy
//      ranks
//      0 12 6 ...                        of the points, in the order of the words' letters
//      newborn ranks
//      31 7 44 ...                       of the newborn points, in the order of newborns_of()
//      end
//
// The ranking is "paper", "farthest", "energy" or "own", which is none of these. Ranks are permutations of
// 0..N-1 and of 0..3N-1, over as many lines as it takes. With the ranking "paper"
// a newborn point has the rank of its own tile, and the file has no "newborn ranks". Blank lines and lines
// that start with # say nothing; everything else must be there, in this order.
//
// A tile of several kinds is of version 2, and packs its numbers as bits, the highest first, into base64:
//
//      dapple tile 2
//      rule 0 0 0 0
//      kinds 4
//      points 1024                       of each kind
//      children
//      2 0 3 1                           for each kind those of its children, by quadrant
//      ...
//      successors
//      gBAE...                           for each kind and quadrant, a line: a bit for each point of the
//      ...                               child's kind, 1 if a point of the quadrant lies on it
//      ranking energy
//      ranks
//      AAIx...                           of the points of kind 0, 12 bits each
//      newborn stages
//      o5eB...                           for each kind, a line: of its newborn points, 4 bits each; see
//      ...                               ranks_of_stages()
//      end

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/export.h"
#include "core/tile/ranking.h"
#include "core/tile/tile.h"

namespace dapple {

/// A tile with its ranking and where that comes from.
struct StoredTile {
    Tile tile;
    std::optional<RankingMethod> method;  // none: ranks of its own
    Ranking ranking;
};

/// "own" for none.
std::string_view name_of(std::optional<RankingMethod> method);

/// A tile ranked by one of the methods.
DAPPLE_API StoredTile ranked(Tile tile, RankingMethod method);

/// The text of a tile. `comments` are lines to stand below the first one, without their #.
DAPPLE_API std::string write_tile(const StoredTile& tile, std::span<const std::string> comments = {});

/// What write_tile() wrote: the same points and ranks to the bit, if those of several kinds are ones of
/// ranks_of_stages(). Throws std::runtime_error, "line 7: ...", if the text is anything else.
DAPPLE_API StoredTile read_tile(std::string_view text);

/// A tile that is not ranked yet: the four digits of the rule on the first line, words on the others, blank
/// lines and comments as above. Throws as read_tile().
Tile read_words(std::string_view text);

/// Whether a text claims to be what write_tile() writes.
bool is_tile_text(std::string_view text);

// The tiles that come with Dapple, and which names are theirs.

struct BuiltInTile {
    const char* name;
    const char* about;  // one line
};

/// In the order in which a list shows them.
const std::vector<BuiltInTile>& built_in_tiles();

/// The names of built_in_tiles(), for lists to choose from.
DAPPLE_API std::span<const char* const> built_in_tile_names();

/// With the ranking that it is stored with. Nothing if no built-in tile has that name.
DAPPLE_API std::optional<StoredTile> built_in_tile(std::string_view name);

/// The same, or of the paper's two integers, ranked by its energy. Throws as parse_tile_integers() does.
DAPPLE_API std::optional<StoredTile> tile_called(std::string_view name);

/// Whether a name is the paper's two integers: "14217,2895/16", which parse_tile_integers() reads.
bool looks_like_tile_integers(std::string_view name);

/// Whether it is neither a built-in tile's nor integers: then it is that of a file.
bool is_tile_file_name(std::string_view name);

}  // namespace dapple
