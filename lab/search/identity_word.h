#pragma once
// The paper's tiles as single words: identity rule, one cyclic word of N quadrant letters '0'..'3'.
//
// Point i is (a_i, b_i) / (2^N - 1), a_i and b_i being the x and y bits of the word from letter i on, so that
// every distance is a whole number of 1 / (2^N - 1) and nothing here is rounded before the end
// (Lagae & Dutré 2006, section 4).

#include <array>
#include <string>
#include <string_view>

#include "core/tile/tile.h"

namespace dapple {

/// Half the smallest distance between two points on the torus, over r_max = sqrt(1 / (2 sqrt(3) N)); 0 if two
/// points coincide. For words of 2..kMaxIdentityWord letters. Squared distances are compared as integers, so
/// tiles of equal distance get the same double.
double relative_radius(std::string_view word);

/// The words of its tile's images under the square's eight symmetries, the word itself first.
std::array<std::string, 8> symmetric_words(std::string_view word);

/// The smallest, letter by letter, of all rotations of the word's images under the square's eight symmetries:
/// two words make the same tile up to symmetry exactly if these are equal.
std::string smallest_symmetric_word(std::string_view word);

/// Share of the 2^length sequences of bits that hold as many ones as zeros, C(length, length / 2) / 2^length;
/// 0 for an odd length. Within 1e-14 for lengths up to 1000.
double balanced_share(int length);

}  // namespace dapple
