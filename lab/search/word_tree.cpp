#include "lab/search/word_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/tile/tile.h"

namespace dapple {

namespace {

constexpr std::uint32_t kStepsPerStopCheck = 4096;

// A slot without a point: too far from everything to matter.
constexpr float kNoPoint = 4;

// With its centre, a square of this many digits is just held by a float. Points known better gain nothing.
constexpr int kDigits = 23;
constexpr float kUnit = 1.0F / (1 << kDigits);

}  // namespace

RadiusBound::RadiusBound(int points, double relative_radius)
    : points_(points), squared_distance_(squared(relative_radius)) {}

void RadiusBound::raise_to(double relative_radius) {
    const float wanted = squared(relative_radius);
    float now = squared_distance();
    while (now < wanted && !squared_distance_.compare_exchange_weak(now, wanted)) {
    }
}

float RadiusBound::squared(double relative_radius) const {
    const double distance =
        2 * relative_radius * std::sqrt(1 / (2 * std::numbers::sqrt3 * static_cast<double>(points_)));
    // The walk's single-precision sums are off by a few 2^-24 at most.
    return static_cast<float>(distance * distance * (1 - 1e-6));
}

WordTree::WordTree(int points) : points_(points) {
    assert(points >= 4 && points <= kMaxIdentityWord && points % 4 == 0);
    for (const Orientation g : all_orientations()) {
        for (int q = 0; q < 4; ++q) image_[g.index][q] = static_cast<std::uint8_t>(apply_to_quadrant(g, q));
    }
    left_.fill(points / 4);
    reach_.fill(kNoPoint);
    for (int i = 0; i < kSlots; ++i) half_side_[i] = std::ldexp(0.5F, -std::min(i + 1, kDigits));
}

std::vector<std::string> WordTree::endings(int length, const RadiusBound& bound) {
    assert(length <= points_);
    std::vector<std::string> endings;
    target_ = length;
    bound_ = &bound;
    stop_ = {};
    on_word_ = [&](const std::string& word) { endings.push_back(word); };
    walk(0, Branch{});
    return endings;
}

bool WordTree::complete(std::string_view ending, const RadiusBound& bound, const std::stop_token& stop,
                        const std::function<void(const std::string&)>& on_word) {
    target_ = points_;
    bound_ = &bound;
    stop_ = stop;
    on_word_ = on_word;
    Branch branch;
    const int length = begin(ending, branch);
    const bool finished = length < static_cast<int>(ending.size()) || walk(length, branch);
    undo_all(length);
    return finished;
}

int WordTree::begin(std::string_view ending, Branch& branch) {
    int length = 0;
    for (auto c = ending.rbegin(); c != ending.rend(); ++c, ++length) {
        Branch next;
        if (!step(length, *c - '0', branch, next)) break;
        branch = next;
    }
    return length;
}

void WordTree::undo_all(int length) {
    while (length > 0) {
        --length;
        undo(length, letters_[length]);
    }
}

double WordTree::probe(std::string_view ending, const RadiusBound& bound, Random& random) {
    bound_ = &bound;
    Branch branch;
    int length = begin(ending, branch);
    double words = 0, each_stands_for = 1;
    while (length >= static_cast<int>(ending.size()) && length < points_) {
        words += each_stands_for;
        std::array<int, 4> open;
        std::size_t count = 0;
        for (int letter = 0; letter < 4; ++letter) {
            Branch next;
            if (left_[letter] == 0 || !step(length, letter, branch, next)) continue;
            undo(length, letter);
            open[count++] = letter;
        }
        if (count == 0) break;
        each_stands_for *= static_cast<double>(count);
        Branch next;
        step(length, open[random.below(count)], branch, next);
        branch = next;
        ++length;
    }
    undo_all(length);
    return words;
}

bool WordTree::walk(int length, const Branch& branch) {
    if (length == target_) {
        std::string word;
        for (int i = length; i-- > 0;) word += static_cast<char>('0' + letters_[i]);
        on_word_(word);
        return true;
    }
    if (++steps_ % kStepsPerStopCheck == 0 && stop_.stop_requested()) return false;
    for (int letter = 0; letter < 4; ++letter) {
        Branch next;
        if (left_[letter] == 0 || !step(length, letter, branch, next)) continue;
        const bool finished = walk(length + 1, next);
        undo(length, letter);
        if (!finished) return false;
    }
    return true;
}

// Puts a letter in front of the word and returns true, or leaves all as it was.
bool WordTree::step(int length, int letter, const Branch& branch, Branch& next) {
    const std::uint64_t here = std::uint64_t{1} << length;
    equal_[letter] |= here;
    for (int k = 0; k < letter; ++k) greater_[k] |= here;
    letters_[length] = static_cast<std::uint8_t>(letter);
    --left_[letter];
    next.x = branch.x >> 1 | static_cast<std::uint32_t>(letter & 1) << 31;
    next.y = branch.y >> 1 | static_cast<std::uint32_t>(letter >> 1) << 31;
    if (!smaller_elsewhere(letter, branch, next) && !too_close(length, next)) return true;
    undo(length, letter);
    return false;
}

void WordTree::undo(int length, int letter) {
    const std::uint64_t here = std::uint64_t{1} << length;
    equal_[letter] &= ~here;
    for (int k = 0; k < letter; ++k) greater_[k] &= ~here;
    ++left_[letter];
    reach_[length] = kNoPoint;
}

// All stretches of the word that, through symmetry g, equal its beginning so far are bits of matches[g]: bit
// m is a stretch of m letters that ends at the latest one. One more letter turns all of them at once into
// longer matches, greater ones, which are of no interest, or a smaller one.
bool WordTree::smaller_elsewhere(int letter, const Branch& branch, Branch& next) const {
    for (std::size_t g = 0; g < 8; ++g) {
        const std::uint8_t seen = image_[g][letter];
        const std::uint64_t stretches = branch.matches[g] | 1;
        if (stretches & greater_[seen]) return true;
        next.matches[g] = (stretches & equal_[seen]) << 1;
    }
    return false;
}

// Whether the point of the letter at `length` is certainly within the bound of an older one; keeps its
// square.
bool WordTree::too_close(int length, const Branch& next) {
    const float reach = half_side_[length];
    const float x = static_cast<float>(static_cast<std::int32_t>(next.x >> (32 - kDigits))) * kUnit + reach;
    const float y = static_cast<float>(static_cast<std::int32_t>(next.y >> (32 - kDigits))) * kUnit + reach;
    const float limit = bound_->squared_distance();
    int close = 0;
    const int end = (length + 7) / 8 * 8;
    for (int i = 0; i < end; ++i) {
        const float dx = std::abs(x_[i] - x), dy = std::abs(y_[i] - y);
        const float both = reach_[i] + reach;
        const float far_x = (dx < 1 - dx ? dx : 1 - dx) + both;
        const float far_y = (dy < 1 - dy ? dy : 1 - dy) + both;
        close |= far_x * far_x + far_y * far_y < limit ? 1 : 0;
    }
    x_[length] = x;
    y_[length] = y;
    reach_[length] = reach;
    return close != 0;
}

}  // namespace dapple
