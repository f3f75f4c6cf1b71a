#include "lab/search/criterion_search.h"

#include <fmt/format.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "lab/search/identity_word.h"
#include "lab/search/word_tree.h"

namespace dapple {
namespace {

// Letters at a word's end that make a part of the work.
constexpr int kEnding = 4;

// The best tiles so far, each once: by its smallest word.
class Best {
 public:
    explicit Best(std::size_t top) : top_(top) {}

    void add(MeasuredTile tile) {
        if (tiles_.size() == top_ && std::tie(tile.cost, tile.word) >= key_of(*tiles_.rbegin())) return;
        const auto is_same = [same = smallest_symmetric_word(tile.word)](const MeasuredTile& other) {
            return smallest_symmetric_word(other.word) == same;
        };
        // One that is reached by another word costs the same, but for what rounding does.
        const auto twin = std::ranges::find_if(tiles_, is_same);
        if (twin != tiles_.end()) {
            if (key_of(*twin) <= std::tie(tile.cost, tile.word)) return;
            tiles_.erase(twin);
        }
        tiles_.insert(std::move(tile));
        if (tiles_.size() > top_) tiles_.erase(std::prev(tiles_.end()));
    }
    void add_all(const Best& others) {
        for (const MeasuredTile& tile : others.tiles_) add(tile);
    }
    std::vector<MeasuredTile> in_order() const { return {tiles_.begin(), tiles_.end()}; }

 private:
    static std::tuple<const double&, const std::string&> key_of(const MeasuredTile& tile) {
        return std::tie(tile.cost, tile.word);
    }
    struct Before {
        bool operator()(const MeasuredTile& a, const MeasuredTile& b) const { return key_of(a) < key_of(b); }
    };
    std::size_t top_;
    std::set<MeasuredTile, Before> tiles_;
};

}  // namespace

CriterionResult search_by_criterion(int points, std::size_t top, const MeasureTile& measure,
                                    const CriterionControl& control) {
    if (points < 4 || points > kMostCriterionPoints || points % 4 != 0)
        throw std::runtime_error(fmt::format("{} points are not possible; give a multiple of 4 from 4 to {}",
                                             points, kMostCriterionPoints));
    const RadiusBound any_radius(points, 0);
    const std::vector<std::string> endings =
        WordTree(points).endings(std::min(kEnding, points - 1), any_radius);
    Best best(top);
    CriterionResult result;
    std::size_t done = 0;
    std::mutex mutex;
    tbb::task_arena arena(control.threads > 0 ? control.threads : tbb::info::default_concurrency());
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, endings.size(), [&](std::size_t part) {
            WordTree tree(points);
            Best found(top);
            std::uint64_t tiles = 0;
            const bool complete =
                tree.complete(endings[part], any_radius, control.stop, [&](const std::string& word) {
                    ++tiles;
                    // One that repeats has fewer places than points.
                    if (relative_radius(word) > 0) found.add(measure(word));
                });
            const std::lock_guard lock(mutex);
            best.add_all(found);
            result.tiles += tiles;
            done += complete ? 1 : 0;
            if (control.on_progress) control.on_progress(double(done) / double(endings.size()));
        });
    });
    result.best = best.in_order();
    result.finished = done == endings.size();
    return result;
}

}  // namespace dapple
