#include "lab/search/relink_search.h"

#include "core/tile/random.h"
#include "lab/search/coherent_peaks.h"

#include <fmt/format.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace dapple {

namespace {

// A point is followed down its predecessors until it moves by less; in spacings.
constexpr double kNegligible = 0.003;
constexpr int kMovesBetweenRefreshes = 256;  // per point
constexpr int kMovesBetweenLooks = 4096;     // at the clock, and whether to stop

// A tile being re-linked: the successors, where the points are, and the grid that knows their energy.
class Links {
 public:
    Links(const Tile& tile, const PairShape& shape, CoherentPeaks peaks)
        : spacings_(std::sqrt(static_cast<double>(tile.size()))),
          neighbours_(legal_neighbours(tile.rule)),
          shape_(shape),
          peaks_(std::move(peaks)),
          successor_(tile.successor),
          predecessors_(tile.size(), {kNone, kNone, kNone, kNone}),
          quadrant_(tile.size()),
          position_(tile.size()),
          point_(tile.size()) {
        for (std::uint32_t i = 0; i < tile.size(); ++i) {
            quadrant_[i] = static_cast<std::uint8_t>(quadrant_of(tile.points[i]));
            predecessors_[successor_[i]][quadrant_[i]] = i;
            position_[i] = (to_unit_square(tile.points[i]) - 0.5) * spacings_;
        }
        for (int q = 0; q < 4; ++q) {
            const Orientation h = tile.rule.child[q];
            const glm::dvec2 x = 0.5 * apply(h, glm::dvec2(1, 0)), y = 0.5 * apply(h, glm::dvec2(0, 1));
            shrink_[q] = {x.x, y.x, (q & 1 ? 0.25 : -0.25) * spacings_,
                          x.y, y.y, (q & 2 ? 0.25 : -0.25) * spacings_};
        }
        refresh();
    }

    std::size_t size() const { return successor_.size(); }
    double energy() const { return energy_ + peaks_.penalty(); }
    double highest_peak() const { return peaks_.highest(); }
    const std::vector<std::uint32_t>& successors() const { return successor_; }

    /// Puts every point exactly where its successors say, and sums the energy afresh.
    void refresh() {
        for (int round = 0; round < 60; ++round) {
            for (std::uint32_t i = 0; i < size(); ++i) position_[i] = image_of_successor(i);
        }
        grid_.emplace(size(), neighbours_, shape_, cell_capacity());
        energy_ = 0;
        for (std::uint32_t i = 0; i < size(); ++i) {
            point_[i] = glm::vec2(position_[i]);
            energy_ += grid_->energy(point_[i]) + grid_->energy_with_itself(point_[i]);
            grid_->insert(point_[i], i);
        }
        peaks_.reset(position_);
    }

    /// Tries one move and takes it if the energy rises by less than temperature * log(1 / chance).
    bool step(Random& random, double temperature, double radius) {
        const std::uint32_t a = random.below(size()), from = successor_[a];
        grid_->find_near(point_[from], static_cast<float>(radius), near_);
        const std::uint32_t to = near_[random.below(near_.size())];
        // Exchanging the successors of two points of one quadrant would only exchange their names.
        if (predecessors_[to][quadrant_[a]] != kNone) return false;

        const double allowed = -temperature * std::log(1 - random.unit());
        // Further down the predecessors points move less: a move that is far too dear by then stays so.
        const double hopeless = allowed + 0.15 + 2 * temperature;
        link(a, from, to);
        journal_.clear();
        queue_.assign(1, a);
        double change = 0;
        for (std::size_t k = 0; k < queue_.size() && change <= hopeless; ++k) {
            const std::uint32_t p = queue_[k];
            const glm::dvec2 target = image_of_successor(p), by = target - position_[p];
            if (by.x * by.x + by.y * by.y < kNegligible * kNegligible) continue;
            if (!grid_->fits(glm::vec2(target))) return undo(a, from, to);
            journal_.push_back({p, position_[p]});
            change += move(p, target);
            for (const std::uint32_t before : predecessors_[p]) {
                if (before != kNone) queue_.push_back(before);
            }
        }
        if (change > allowed) return undo(a, from, to);
        // The peaks are dear to look at: a second draw of chance, for the few moves that come so far, makes
        // the same equilibrium as one for the sum.
        if (!peaks_.empty()) {
            moves_.clear();
            for (const Moved& moved : journal_) moves_.push_back({moved.from, position_[moved.point]});
            if (peaks_.try_moves(moves_) > -temperature * std::log(1 - random.unit()))
                return undo(a, from, to);
            peaks_.take();
        }
        energy_ += change;
        return true;
    }

 private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    struct Moved {
        std::uint32_t point;
        glm::dvec2 from;
    };

    // Twice what the most crowded cell holds: a search soon makes them even.
    int cell_capacity() const {
        const int side = EnergyGrid::cells_a_side(size(), shape_);
        const auto cell_on_axis = [&](double v) {
            return std::clamp(static_cast<int>((v / spacings_ + 0.5) * side), 0, side - 1);
        };
        std::vector<int> held(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
        for (const glm::dvec2 p : position_)
            ++held[static_cast<std::size_t>(cell_on_axis(p.y) * side + cell_on_axis(p.x))];
        return 16 + 2 * *std::max_element(held.begin(), held.end());
    }

    glm::dvec2 image_of_successor(std::uint32_t i) const {
        const auto& m = shrink_[quadrant_[i]];
        const glm::dvec2 p = position_[successor_[i]];
        return {m[0] * p.x + m[1] * p.y + m[2], m[3] * p.x + m[4] * p.y + m[5]};
    }

    void link(std::uint32_t a, std::uint32_t from, std::uint32_t to) {
        successor_[a] = to;
        predecessors_[from][quadrant_[a]] = kNone;
        predecessors_[to][quadrant_[a]] = a;
    }

    double move(std::uint32_t p, glm::dvec2 target) {
        const glm::vec2 to(target);
        grid_->remove(point_[p], p);
        const double before = grid_->energy(point_[p]) + grid_->energy_with_itself(point_[p]);
        const double after = grid_->energy(to) + grid_->energy_with_itself(to);
        position_[p] = target;
        point_[p] = to;
        grid_->insert(to, p);
        return after - before;
    }

    bool undo(std::uint32_t a, std::uint32_t from, std::uint32_t to) {
        link(a, to, from);
        for (; !journal_.empty(); journal_.pop_back()) {
            const auto [p, origin] = journal_.back();
            grid_->remove(point_[p], p);
            position_[p] = origin;
            point_[p] = glm::vec2(origin);
            grid_->insert(point_[p], p);
        }
        return false;
    }

    double spacings_;  // a side of the tile
    std::vector<Neighbour> neighbours_;
    PairShape shape_;
    CoherentPeaks peaks_;
    std::vector<std::uint32_t> successor_;
    std::vector<std::array<std::uint32_t, 4>> predecessors_;  // the one in each quadrant
    std::vector<std::uint8_t> quadrant_;
    std::vector<glm::dvec2> position_;  // in spacings from the tile's centre
    std::vector<glm::vec2> point_;      // the same as the grid has it
    std::array<std::array<double, 6>, 4> shrink_;
    std::optional<EnergyGrid> grid_;
    double energy_ = 0;
    std::vector<Moved> journal_;
    std::vector<CoherentPeaks::Move> moves_;
    std::vector<std::uint32_t> near_, queue_;
};

bool repeats_itself(const std::string& word) {
    return (word + word).find(word, 1) < word.size();
}

// The share of the time that has passed; it may be over before it begins.
double share_of(double elapsed, double seconds) {
    return elapsed < seconds ? elapsed / seconds : 1;
}

}  // namespace

Rule aperiodic_rule() {
    return Rule{{Orientation{3}, Orientation{7}, Orientation{6}, Orientation{0}}};
}

std::vector<std::string> even_words(std::size_t points, std::uint64_t seed) {
    if (points == 0 || points % 4 != 0 || points > kMaxTilePoints) {
        throw std::runtime_error(fmt::format(
            "a tile of {} points cannot be made; use a multiple of 4 up to {}", points, kMaxTilePoints));
    }
    std::size_t windows = 4;
    while (points % (windows * 4) == 0) windows *= 4;
    const std::size_t nodes = windows / 4, copies = points / windows;
    Random random(seed);
    for (;;) {
        // Hierholzer's walk through every edge once; an edge from node v with letter c goes to 4 v + c.
        std::vector<std::string> edges(nodes);
        for (std::string& letters : edges) {
            for (std::size_t c = 0; c < copies; ++c) letters += "0123";
            for (std::size_t k = letters.size(); k > 1; --k)
                std::swap(letters[k - 1], letters[random.below(k)]);
        }
        std::string word;
        std::vector<std::pair<std::size_t, char>> path{{0, ' '}};
        while (!path.empty()) {
            const auto [node, letter] = path.back();
            if (edges[node].empty()) {
                path.pop_back();
                if (!path.empty()) word += letter;
            } else {
                const char next = edges[node].back();
                edges[node].pop_back();
                path.emplace_back((node * 4 + static_cast<std::size_t>(next - '0')) % nodes, next);
            }
        }
        std::reverse(word.begin(), word.end());
        if (!repeats_itself(word)) return {word};
    }
}

double relink_energy(const Tile& tile, const PairShape& shape) {
    return Links(tile, shape, CoherentPeaks(tile.size(), 0, 0)).energy() / static_cast<double>(tile.size());
}

RelinkResult relink_search(const RelinkSettings& settings) {
    const double begun = settings.clock ? settings.clock() : 0;
    const Tile start = make_tile(
        settings.rule, settings.start.empty() ? even_words(settings.points, settings.seed) : settings.start);
    std::string letters;
    for (const BinaryPoint p : start.points) letters += static_cast<char>('0' + quadrant_of(p));
    const auto count = static_cast<double>(start.size());

    Random random(settings.seed);
    Links links(start, settings.shape,
                CoherentPeaks(start.size(), settings.peak_weight, settings.peak_limit));
    RelinkProgress progress;
    progress.rule = settings.rule;
    progress.seed = settings.seed;
    progress.energy = progress.best = links.energy() / count;
    progress.words = start.words;
    const std::uint64_t report_after = kMovesBetweenRefreshes * start.size();
    std::uint64_t taken = 0, reported = 0;
    double done = settings.clock || settings.moves > 0 ? 0 : 1;  // share of the search
    while (done < 1 && !settings.stop.stop_requested()) {
        const double temperature = settings.start_temperature *
                                   std::pow(settings.end_temperature / settings.start_temperature, done);
        // In rounds short enough to be stopped at any time.
        std::uint64_t round =
            std::min<std::uint64_t>(report_after - progress.moves % report_after, kMovesBetweenLooks);
        if (!settings.clock) round = std::min(round, settings.moves - progress.moves);
        for (std::uint64_t k = 0; k < round; ++k)
            taken += links.step(random, temperature, settings.move_radius);
        progress.moves += round;
        done = settings.clock ? share_of(settings.clock() - begun, settings.seconds)
                              : static_cast<double>(progress.moves) / static_cast<double>(settings.moves);
        if (progress.moves % report_after != 0 && done < 1 && !settings.stop.stop_requested()) continue;
        links.refresh();
        progress.energy = links.energy() / count;
        progress.highest_peak = links.highest_peak();
        progress.new_moves = progress.moves - std::exchange(reported, progress.moves);
        progress.acceptance =
            static_cast<double>(std::exchange(taken, 0)) / static_cast<double>(progress.new_moves);
        if (progress.energy < progress.best) {
            progress.best = progress.energy;
            progress.words = words_along(letters, links.successors());
        }
        if (settings.progress) settings.progress(progress);
    }
    return {make_tile(settings.rule, progress.words), progress.best, progress.moves};
}

std::vector<RelinkResult> relink_searches(std::vector<RelinkSettings> runs) {
    // More threads than cores would make each run slower, and none of them sooner.
    const auto cores = static_cast<std::size_t>(
        std::min(tbb::this_task_arena::max_concurrency(), tbb::info::default_concurrency()));
    const std::size_t turns = (runs.size() + cores - 1) / cores;
    std::vector<RelinkResult> results(runs.size());
    tbb::parallel_for(
        std::size_t{0}, runs.size(),
        [&](std::size_t k) {
            runs[k].seconds /= static_cast<double>(turns);
            results[k] = relink_search(runs[k]);
        },
        tbb::simple_partitioner());
    std::ranges::stable_sort(results, {}, &RelinkResult::energy);
    return results;
}

std::vector<RelinkResult> relink_searches(const RelinkSettings& settings, int runs) {
    std::vector<RelinkSettings> seeded(static_cast<std::size_t>(std::max(runs, 0)), settings);
    for (std::size_t k = 0; k < seeded.size(); ++k) seeded[k].seed += k;
    return relink_searches(std::move(seeded));
}

}  // namespace dapple
