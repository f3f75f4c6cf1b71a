#include "core/tile/neighbours.h"

#include <array>

namespace dapple {

namespace {

// How often each relative orientation of each kind occurs at each offset from each kind; the centre holds the
// tile itself.
class Table {
 public:
    explicit Table(std::size_t kinds) : kinds_(kinds), chances_(9 * 8 * kinds * kinds, 0.0) {}

    double& at(std::size_t of, glm::ivec2 offset, std::size_t kind, Orientation g) {
        const auto place = static_cast<std::size_t>(3 * (offset.x + 1) + offset.y + 1);
        return chances_[((of * 9 + place) * kinds_ + kind) * 8 + g.index];
    }
    double at(std::size_t of, glm::ivec2 offset, std::size_t kind, Orientation g) const {
        return const_cast<Table&>(*this).at(of, offset, kind, g);
    }
    std::size_t kinds() const { return kinds_; }
    void add(const Table& other) {
        for (std::size_t i = 0; i < chances_.size(); ++i) chances_[i] += other.chances_[i];
    }

 private:
    std::size_t kinds_;
    std::vector<double> chances_;
};

// All that have a place in a table, in its order.
template <class Visit>
void for_each_entry(std::size_t kinds, Visit visit) {
    for (std::size_t of = 0; of < kinds; ++of) {
        for (int ox = -1; ox <= 1; ++ox) {
            for (int oy = -1; oy <= 1; ++oy) {
                for (std::size_t kind = 0; kind < kinds; ++kind) {
                    for (const Orientation g : all_orientations()) visit(of, glm::ivec2(ox, oy), kind, g);
                }
            }
        }
    }
}

constexpr int kSettlingRounds =
    200;  // far beyond the few rounds in which the chance of each neighbour settles

glm::ivec2 turn(Orientation g, glm::ivec2 v) {
    return glm::ivec2(apply(g, glm::dvec2(v)));
}

// Where the child in quadrant q lies in a tile with the given orientation, as 0 or 1 on each axis.
glm::ivec2 child_cell(Orientation g, int q) {
    const int placed = apply_to_quadrant(g, q);
    return {placed & 1, placed >> 1};
}

// One subdivision: from the neighbours that tiles have to those that their children have.
Table subdivide(const Rule& rule, const NextKinds& next_kind, const Table& parents) {
    Table children(parents.kinds());
    for_each_entry(parents.kinds(), [&](std::size_t of, glm::ivec2 o, std::size_t kind, Orientation other) {
        const double weight = parents.at(of, o, kind, other);
        if (weight == 0) return;
        for (std::size_t q = 0; q < 4; ++q) {
            const Orientation frame = inverse(rule.child[q]);
            for (std::size_t r = 0; r < 4; ++r) {
                const glm::ivec2 between = 2 * o + child_cell(other, static_cast<int>(r)) -
                                           child_cell(Orientation{}, static_cast<int>(q));
                if (between.x * between.x > 1 || between.y * between.y > 1) continue;
                const Orientation seen = compose(frame, compose(other, rule.child[r]));
                children.at(next_kind[of][q], turn(frame, between), next_kind[kind][r], seen) += weight / 4;
            }
        }
    });
    return children;
}

}  // namespace

std::vector<Neighbour> legal_neighbours(const Rule& rule, const NextKinds& next_kind) {
    const std::size_t kinds = next_kind.size();
    Table table(kinds), occurred(kinds), settled(kinds);
    table.at(0, {0, 0}, 0, {}) = 1;  // a lone tile
    for (int round = 0; round < kSettlingRounds; ++round) {
        table = subdivide(rule, next_kind, table);
        occurred.add(table);
        // The chances may alternate from level to level: average over the later half.
        if (round >= kSettlingRounds / 2) settled.add(table);
    }

    std::vector<Neighbour> neighbours;
    std::vector<double> sums(9 * kinds, 0.0);  // of a kind and an offset
    const auto sum_at = [&](std::size_t of, glm::ivec2 o) -> double& {
        return sums[of * 9 + static_cast<std::size_t>(3 * (o.x + 1) + o.y + 1)];
    };
    for_each_entry(kinds, [&](std::size_t of, glm::ivec2 o, std::size_t kind, Orientation g) {
        sum_at(of, o) += settled.at(of, o, kind, g);
    });
    for_each_entry(kinds, [&](std::size_t of, glm::ivec2 o, std::size_t kind, Orientation g) {
        if (o == glm::ivec2(0) || occurred.at(of, o, kind, g) == 0) return;
        const double sum = sum_at(of, o);
        neighbours.push_back({o, g, sum > 0 ? settled.at(of, o, kind, g) / sum : 0,
                              static_cast<std::uint16_t>(of), static_cast<std::uint16_t>(kind)});
    });
    return neighbours;
}

std::vector<std::vector<Neighbour>> copies_of_kinds(const Tile& tile) {
    std::vector<std::vector<Neighbour>> copies(tile.kinds());
    for (const Neighbour& n : legal_neighbours(tile.rule, tile.next_kind)) copies[n.kind].push_back(n);
    return copies;
}

glm::dvec2 position_in(const Neighbour& neighbour, glm::dvec2 p) {
    return glm::dvec2(neighbour.offset) + apply(neighbour.orientation, p - 0.5) + 0.5;
}

}  // namespace dapple
