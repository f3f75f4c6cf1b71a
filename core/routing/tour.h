#pragma once
// A closed way through stops, kept as an array of them: a move turns a stretch of it round.

#include <cstdint>
#include <utility>
#include <vector>

namespace dapple {

/// An open way's stops, and one more that joins its ends.
inline std::vector<std::uint32_t> joined(std::vector<std::uint32_t> way) {
    way.push_back(static_cast<std::uint32_t>(way.size()));
    return way;
}

/// Through the stops 0, 1, .. in any order. An open way is one of one more stop, which joins its two ends
/// and is no distance from them.
class Tour {
 public:
    explicit Tour(std::vector<std::uint32_t> stops) : stops_(std::move(stops)), place_(stops_.size()) {
        for (std::uint32_t place = 0; place < size(); ++place) place_[stops_[place]] = place;
    }

    std::uint32_t size() const { return static_cast<std::uint32_t>(stops_.size()); }
    std::uint32_t at(std::uint32_t place) const { return stops_[place]; }
    std::uint32_t place(std::uint32_t stop) const { return place_[stop]; }

    std::uint32_t after(std::uint32_t stop) const {
        const std::uint32_t place = place_[stop] + 1;
        return stops_[place == size() ? 0 : place];
    }
    std::uint32_t before(std::uint32_t stop) const {
        const std::uint32_t place = place_[stop];
        return stops_[place == 0 ? size() - 1 : place - 1];
    }
    std::uint32_t beside(std::uint32_t stop, bool forward) const {
        return forward ? after(stop) : before(stop);
    }

    /// In place of a-b and c-d there will be a-c and b-d; b follows a as d follows c, on either way round.
    void exchange(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        if (after(a) == b)
            turn(place_[b], place_[c]);
        else
            turn(place_[a], place_[d]);
    }

    /// The stops from the one after that to the one before it, which leaves out this one itself.
    std::vector<std::uint32_t> opened_at(std::uint32_t stop) const {
        std::vector<std::uint32_t> way;
        way.reserve(size() - 1);
        for (std::uint32_t next = after(stop); next != stop; next = after(next)) way.push_back(next);
        return way;
    }

 private:
    // Turns the stops at these places round, or all the others, which is the same tour.
    void turn(std::uint32_t from, std::uint32_t to) {
        const std::uint32_t count = size();
        std::uint32_t length = (to + count - from) % count + 1;
        if (2 * length > count) {
            std::swap(from, to);
            from = from + 1 == count ? 0 : from + 1;
            to = to == 0 ? count - 1 : to - 1;
            length = count - length;
        }
        for (std::uint32_t swaps = length / 2; swaps > 0; --swaps) {
            std::swap(stops_[from], stops_[to]);
            place_[stops_[from]] = from;
            place_[stops_[to]] = to;
            from = from + 1 == count ? 0 : from + 1;
            to = to == 0 ? count - 1 : to - 1;
        }
    }

    std::vector<std::uint32_t> stops_, place_;
};

}  // namespace dapple
