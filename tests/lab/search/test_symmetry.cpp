#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <utility>

#include "lab/search/symmetry.h"

namespace dapple {

TEST_CASE("the best tiles have every quarter turn and no mirror, as a count by hand of all moves says") {
    struct Counted {
        const char* word;
        double identity, quarter, half, mirrored;  // shares
    };
    // The paper's tile, which is the second best of its size, and the best of 12, 16 and 20 points.
    for (const Counted& counted : {Counted{"0011213312003223", 5.0 / 16, 5.0 / 16, 6.0 / 16, 4.0 / 16},
                                   Counted{"003112330221", 11.0 / 12, 1, 1, 1.0 / 12},
                                   Counted{"0030112133032212", 4.0 / 16, 1, 1, 3.0 / 16},
                                   Counted{"00123220313321011302", 1, 1, 1, 1.0 / 20}}) {
        CAPTURE(counted.word);
        const std::array<double, 8> shares = symmetry_shares(make_tile(Rule{}, {counted.word}));
        CHECK(shares[0] == doctest::Approx(counted.identity));
        CHECK(shares[1] == doctest::Approx(counted.quarter));
        CHECK(shares[2] == doctest::Approx(counted.half));
        CHECK(shares[3] == doctest::Approx(counted.quarter));
        for (std::size_t g = 4; g < 8; ++g) CHECK(shares[g] == doctest::Approx(counted.mirrored));
    }
}

TEST_CASE("the best tiles of 12 and 20 points are rank-1 lattices of 13 and 25 points with holes") {
    struct Lattice {
        const char* word;
        int points, a, b, holes_at;
    };
    for (const Lattice& lattice :
         {Lattice{"003112330221", 13, 3, 2, 13}, Lattice{"00123220313321011302", 25, 4, 3, 5}}) {
        CAPTURE(lattice.word);
        std::set<std::pair<long, long>> expected, found;
        for (int k = 0; k < lattice.points; ++k)
            if (k % lattice.holes_at != 0)
                expected.insert({k * lattice.a % lattice.points, k * lattice.b % lattice.points});
        for (const BinaryPoint p : make_tile(Rule{}, {lattice.word}).points) {
            const glm::dvec2 scaled = to_unit_square(p) * double(lattice.points);
            CHECK(std::abs(scaled.x - std::round(scaled.x)) + std::abs(scaled.y - std::round(scaled.y)) <
                  1e-9);
            found.insert({std::lround(scaled.x), std::lround(scaled.y)});
        }
        CHECK(found == expected);
    }
}

}  // namespace dapple
