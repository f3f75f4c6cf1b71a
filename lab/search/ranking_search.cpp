#include "lab/search/ranking_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/tile/random.h"
#include "core/tile/ranking.h"
#include "lab/search/criteria.h"

namespace dapple {

namespace {

constexpr int kBins = 1024;  // of the squared distance, up to the widest reach

// A pair of a newborn point with another point or a copy of one.
struct Partner {
    std::uint32_t point;  // newborn: its number; the tile's own: 3 N + its number
    std::uint16_t bin;
    float weight;  // how often the copy occurs; half for a point's own copies, which move with it
};

// The stages of the points, and the energy of all pairs of newborn points with what is about them.
class Stages {
 public:
    Stages(const Tile& tile, const Ranking& ranking, const RankingSearchSettings& settings)
        : stages_(tile.kinds() > 1 ? kRankStages : settings.stages), newborn_(3 * tile.points.size()) {
        const auto count = static_cast<double>(tile.size());
        const auto size_at = [&](int s) { return count * std::pow(4.0, static_cast<double>(s) / stages_); };
        stage_.assign(newborn_ + tile.points.size(), 0);
        for (std::size_t i = 0; i < newborn_; ++i) {
            while (stage_[i]<stages_&& static_cast<double>(ranking.newborn[i])> size_at(stage_[i]))
                ++stage_[i];
        }

        const double reach2 =
            std::pow(std::max(4 * settings.shape.tone_width, settings.shape.close_radius), 2) / size_at(1);
        table_.resize(static_cast<std::size_t>(stages_ + 1) * kBins, 0.0f);
        for (int bin = 0; bin < kBins; ++bin) {
            double sum = 0;
            for (int s = stages_; s >= 0; --s) {
                // All pairs are there at the last stage, whatever the order.
                if (s > 0 && s < stages_)
                    sum += pair_energy(settings.shape, (bin + 0.5) / kBins * reach2 * size_at(s));
                table_[static_cast<std::size_t>(s * kBins + bin)] = static_cast<float>(sum);
            }
        }

        std::vector<glm::dvec2> places;
        for (const Newborn& n : newborns_of(tile)) places.push_back(to_unit_square(n.position));
        for (const BinaryPoint p : tile.points) places.push_back(to_unit_square(p));
        for (std::size_t i = 0; i < newborn_; ++i) kind_.push_back(i / (3 * tile.size()));
        for (std::size_t i = 0; i < tile.points.size(); ++i) kind_.push_back(tile.kind_of(i));
        const GridOfKinds grid(places, kind_, tile.kinds());
        const auto copies = copies_of_kinds(tile);
        std::vector<std::vector<Partner>> partners(newborn_);
        for (std::uint32_t j = 0; j < places.size(); ++j) {
            const auto visit = [&](glm::dvec2 copy, double probability, std::size_t of) {
                const bool is_itself = copy == places[j];
                grid.for_each_near(of, copy, std::sqrt(reach2), [&](std::uint32_t i, double squared) {
                    if (i >= newborn_ || (i == j && is_itself)) return;
                    const auto bin = static_cast<std::uint16_t>(std::min(squared / reach2, 0.9999) * kBins);
                    partners[i].push_back(
                        {j, bin, static_cast<float>(i == j ? probability / 2 : probability)});
                });
            };
            for_copies(places[j], kind_[j], copies[kind_[j]], std::sqrt(reach2), visit);
        }
        for (const auto& list : partners) {
            first_.push_back(static_cast<std::uint32_t>(partners_.size()));
            partners_.insert(partners_.end(), list.begin(), list.end());
        }
        first_.push_back(static_cast<std::uint32_t>(partners_.size()));
    }

    std::size_t newborns() const { return newborn_; }
    int stage(std::size_t i) const { return stage_[i]; }

    /// Tries to exchange the stages of a point and of one near it.
    bool step(Random& random, double temperature) {
        const std::uint32_t a = random.below(newborn_);
        const std::uint32_t b = partners_[first_[a] + random.below(first_[a + 1] - first_[a])].point;
        if (b >= newborn_ || stage_[a] == stage_[b] || kind_[a] != kind_[b]) return false;
        const int of_a = stage_[a], of_b = stage_[b];
        double change = restage(a, of_b);
        change += restage(b, of_a);
        if (change <= -temperature * std::log(1 - random.unit())) return true;
        stage_[a] = of_a;
        stage_[b] = of_b;
        return false;
    }

    double energy() const {
        double sum = 0;
        for (std::uint32_t i = 0; i < newborn_; ++i) {
            for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
                const Partner& p = partners_[k];
                // Two newborn points meet in both lists; a point's own copies have half the weight already.
                const float share = p.point < newborn_ && p.point != i ? 0.5f : 1.0f;
                sum +=
                    static_cast<double>(share * p.weight * at(std::max(stage_[i], stage_[p.point]), p.bin));
            }
        }
        return sum;
    }

 private:
    float at(int stage, int bin) const { return table_[static_cast<std::size_t>(stage * kBins + bin)]; }

    double restage(std::uint32_t i, int to) {
        const int from = stage_[i];
        float change = 0;
        for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
            const Partner& p = partners_[k];
            // A point's own copies change stage with it.
            const int other = p.point == i ? 0 : stage_[p.point];
            if (other >= from && other >= to) continue;
            change += p.weight * (at(std::max(to, other), p.bin) - at(std::max(from, other), p.bin));
        }
        stage_[i] = to;
        return static_cast<double>(change);
    }

    int stages_;
    std::size_t newborn_;
    std::vector<std::size_t> kind_;
    std::vector<int> stage_;    // newborn points: 1..stages; the tile's own: 0
    std::vector<float> table_;  // energy of a pair by the stage of its later point, then by distance
    std::vector<Partner> partners_;
    std::vector<std::uint32_t> first_;  // of each newborn point in partners_
};

}  // namespace

Ranking search_ranking(const Tile& tile, const RankingSearchSettings& settings) {
    const Ranking start = rank(tile, RankingMethod::energy);
    Stages stages(tile, start, settings);
    const std::uint64_t exchanges = settings.exchanges > 0 ? settings.exchanges : 1000 * stages.newborns();
    Random random(settings.seed);
    double temperature = settings.start_temperature;
    for (std::uint64_t k = 0; k < exchanges; ++k) {
        if (k % 4096 == 0) {
            if (settings.stop.stop_requested()) break;
            temperature = settings.start_temperature *
                          std::pow(settings.end_temperature / settings.start_temperature,
                                   static_cast<double>(k) / static_cast<double>(exchanges));
        }
        stages.step(random, temperature);
    }
    std::vector<int> stage;
    const int first = tile.kinds() > 1 ? 1 : 0;
    for (std::size_t i = 0; i < stages.newborns(); ++i) stage.push_back(stages.stage(i) - first);
    if (tile.kinds() > 1) return {start.tile, ranks_of_stages(tile.size(), stage)};
    return {start.tile, rank_newborns_in_stages(tile, stage)};
}

double ranking_energy(const Tile& tile, const Ranking& ranking, const RankingSearchSettings& settings) {
    const Stages stages(tile, ranking, settings);
    return stages.energy() / static_cast<double>(stages.newborns());
}

}  // namespace dapple
