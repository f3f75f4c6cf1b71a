#include <doctest/doctest.h>

#include <cmath>

#include "app/viewer/background/dot_blocks.h"

namespace dapple {

TEST_CASE("blocks hold every dot once, in order, and none lies outside its box") {
    DotPieces dots;
    for (const std::size_t size : {0, 1, 4096, 10'000, 0, 4097}) {
        Dots piece;
        piece.resize(size, false);
        piece.radius.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            piece.x[i] = static_cast<float>(std::fmod(static_cast<double>(i) * 0.618, 1));
            piece.y[i] = static_cast<float>(i) / 10'000;
            piece.radius[i] = static_cast<float>(1 + i % 5);
        }
        dots.pieces.push_back(std::move(piece));
    }
    std::size_t index = 0;
    double radii = 0;
    for (const DotBlock& block : dot_blocks(dots)) {
        CHECK(block.index == index);
        CHECK(block.count > 0);
        CHECK(block.count <= kDotsPerBlock);
        index += block.count;
        radii += block.radii;
        CHECK(block.largest_radius <= 5);
        const Dots& piece = dots.pieces[block.piece];
        for (std::size_t i = block.first; i < block.first + block.count; ++i) {
            REQUIRE(piece.x[i] >= block.low.x);
            REQUIRE(piece.x[i] <= block.high.x);
            REQUIRE(piece.y[i] >= block.low.y);
            REQUIRE(piece.y[i] <= block.high.y);
        }
    }
    CHECK(index == dots.size());
    CHECK(radii > 2.9 * static_cast<double>(index));
}

TEST_CASE("no dots are no blocks") {
    CHECK(dot_blocks({}).empty());
    CHECK(dot_blocks({{Dots{}, Dots{}}}).empty());
}

}  // namespace dapple
