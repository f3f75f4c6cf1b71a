#pragma once
// Dots into pieces, as threads leave them, and back.

#include <cstddef>

#include "core/placing/dots.h"
#include "core/placing/placer.h"

namespace dapple {

/// The first third and the rest, between empty pieces.
inline DotPieces split(const Dots& dots) {
    DotPieces result;
    result.pieces.resize(5);
    for (FloatBuffer Dots::*column : {&Dots::x, &Dots::y, &Dots::threshold, &Dots::critical, &Dots::radius}) {
        const FloatBuffer& whole = dots.*column;
        const auto third = whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 3);
        (result.pieces[1].*column).assign(whole.begin(), third);
        (result.pieces[3].*column).assign(third, whole.end());
    }
    return result;
}

inline Dots joined(const DotPieces& dots) {
    Dots whole;
    for (const Dots& piece : dots.pieces) append(whole, piece);
    return whole;
}

/// Counts the pieces too, if asked to.
inline Dots all_of(const DotStream& stream, std::size_t* pieces = nullptr) {
    Dots whole;
    stream.for_each_piece([&](const Dots& piece) {
        append(whole, piece);
        if (pieces) ++*pieces;
        return true;
    });
    return whole;
}

}  // namespace dapple
