#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/placing/placer.h"
#include "core/placing/placer_memory.h"
#include "core/placing/tie_order.h"

namespace dapple {

namespace {

constexpr double kMaxScale = 1e30;

// The end of an exact drawing lies within this share of the expected scale with near certainty: the count
// strays less than chance would.
double margin(std::uint64_t count) {
    return 0.005 + 2 / std::sqrt(static_cast<double>(count));
}

PlacingRequest request_at(const ExactCount& request, double scale) {
    PlacingRequest placing;
    placing.scale = scale;
    placing.appearance = request.appearance;
    placing.threads = request.threads;
    return placing;
}

TieKey tie_of(const Dots& dots, const LateDot& dot) {
    return tie_key(dots.x[dot.index], dots.y[dot.index], dot.threshold);
}

// Drops the dots beyond a cut from a drawing that comes whole or piece after piece.
class Cutter {
 public:
    Cutter(const CountCut& cut, std::vector<std::size_t>& dropped)
        : limit_(cut.limit), last_tie_(cut.last_tie), dropped_(dropped) {}

    void cut(Dots& dots, const LateDots& late) {
        dropped_.clear();
        for (const LateDot& dot : late) {
            const bool stays =
                dot.critical < limit_ || (dot.critical == limit_ && tie_of(dots, dot) <= last_tie_);
            if (!stays) dropped_.push_back(dot.index);
        }
        if (dropped_.empty()) return;
        for (FloatBuffer* column : {&dots.x, &dots.y, &dots.threshold, &dots.critical}) {
            if (!column->empty()) close_gaps(*column);
        }
    }

 private:
    void close_gaps(FloatBuffer& column) const {
        const auto begin = column.begin();
        const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
        auto to = at(dropped_.front());
        for (std::size_t i = 0; i < dropped_.size(); ++i) {
            const auto end = i + 1 < dropped_.size() ? at(dropped_[i + 1]) : column.end();
            to = std::copy(at(dropped_[i]) + 1, end, to);
        }
        column.resize(column.size() - dropped_.size());
    }

    float limit_;
    TieKey last_tie_;
    std::vector<std::size_t>& dropped_;
};

// Counts the dots of a drawing that nobody keeps, and keeps what a cut needs of the late ones.
class Counter : public PieceTaker {
 public:
    explicit Counter(LateDots& late) : late_(late) { late_.clear(); }
    bool take_in_turn(PieceMemory& piece) override {
        count_ += piece.dots.size();
        for (const LateDot& dot : piece.emitter.late) {
            late_.push_back({keys_.size(), dot.threshold, dot.critical});
            keys_.push_back(tie_of(piece.dots, dot));
        }
        return true;
    }
    std::size_t count() const { return count_; }
    std::vector<TieKey> take_keys() { return std::move(keys_); }  // by LateDot::index

 private:
    LateDots& late_;
    std::vector<TieKey> keys_;
    std::size_t count_ = 0;
};

// Where a drawing ends in which `kept` of the late dots stay; one or more.
template <class KeyOf>
CountCut cut_among(PlacerMemory& memory, std::size_t kept, KeyOf key_of) {
    const LateDots& late = memory.emitter.late;
    std::vector<float>& criticals = memory.criticals;
    criticals.clear();
    for (const LateDot& dot : late) criticals.push_back(dot.critical);
    const auto last = criticals.begin() + static_cast<std::ptrdiff_t>(kept - 1);
    std::nth_element(criticals.begin(), last, criticals.end());
    CountCut cut;
    cut.limit = *last;
    const auto kept_ties = std::count(criticals.begin(), last, cut.limit);
    std::vector<TieKey>& ties = memory.ties;
    ties.clear();
    for (const LateDot& dot : late) {
        if (dot.critical == cut.limit) ties.push_back(key_of(dot));
    }
    std::nth_element(ties.begin(), ties.begin() + kept_ties, ties.end());
    cut.last_tie = ties[static_cast<std::size_t>(kept_ties)];
    return cut;
}

// Tries scales until the end of the drawing lies between two of them. place(scale, early scale) places and
// returns how many dots there are, the late ones of them in memory; nothing if stopped. key_of() gives the
// tie key of a late dot.
template <class Place, class KeyOf>
std::optional<CountCut> find_end(const Density& density, std::uint64_t count, PlacerMemory& memory,
                                 Place place, KeyOf key_of) {
    if (!(density.mean() > 0)) {
        throw std::runtime_error(
            "there is nothing to draw: the picture is white everywhere; darken it or invert it");
    }
    const double expected = static_cast<double>(count) / (16 * density.mean());
    const double more = 1 + margin(count);
    double early = expected * std::max(0.0, 2 - more), scale = expected * more;
    // The share by which a count is off, and a little; small drawings grow by steps of a whole tile's ranks.
    const auto step = [more](double share) { return std::clamp(share * more, more, 4.0); };
    while (true) {
        const std::optional<std::size_t> placed = place(scale, early);
        if (!placed) return std::nullopt;
        const std::size_t sure = *placed - memory.emitter.late.size();
        if (*placed < count) {
            if (scale > kMaxScale) {
                throw std::runtime_error("so many dots do not fit: the picture's dark part is too small");
            }
            early = scale;
            scale *= step(static_cast<double>(count + 1) / static_cast<double>(*placed + 1));
            continue;
        }
        if (sure < count) {
            CountCut cut = cut_among(memory, count - sure, key_of);
            cut.scale = scale;
            cut.early_scale = early;
            if (cut.limit >= early) return cut;
        } else {
            scale = early;
        }
        early /= step(static_cast<double>(sure + 1) / static_cast<double>(count + 1));
    }
}

}  // namespace

double CountCut::last_scale() const {
    return std::nextafter(limit, std::numeric_limits<float>::max());  // a dot exists above its critical scale
}

std::optional<double> Placer::place_exactly(const Density& density, const ExactCount& request, Dots& dots,
                                            std::stop_token stop) {
    if (request.count == 0) {
        dots = {};
        return 0.0;
    }
    const auto place = [&](double scale, double early) -> std::optional<std::size_t> {
        const Traversal traversal(table_, density, request_at(request, scale), early);
        if (!place_columns(traversal, *memory_, dots, stop)) return std::nullopt;
        return dots.size();
    };
    const auto key_of = [&](const LateDot& dot) { return tie_of(dots, dot); };
    const std::optional<CountCut> cut = find_end(density, request.count, *memory_, place, key_of);
    if (!cut) return std::nullopt;
    Cutter(*cut, memory_->dropped).cut(dots, memory_->emitter.late);
    return cut->last_scale();
}

std::optional<CountCut> Placer::find_cut(const Density& density, const ExactCount& request,
                                         std::stop_token stop) {
    if (request.count == 0) return CountCut{};
    std::vector<TieKey> keys;
    const auto place = [&](double scale, double early) -> std::optional<std::size_t> {
        Counter counter(memory_->emitter.late);
        const Traversal traversal(table_, density, request_at(request, scale), early);
        if (!hand_over_pieces(traversal, *memory_, counter, stop)) return std::nullopt;
        keys = counter.take_keys();
        return counter.count();
    };
    return find_end(density, request.count, *memory_, place,
                    [&](const LateDot& dot) { return keys[dot.index]; });
}

bool Placer::place_in_pieces(const Density& density, const ExactCount& request, const CountCut& cut,
                             const TakePiece& take, std::stop_token stop) {
    class CutStream : public PieceTaker {
     public:
        CutStream(Cutter cutter, const TakePiece& take) : cutter_(cutter), take_(take) {}
        bool take_in_turn(PieceMemory& piece) override {
            cutter_.cut(piece.dots, piece.emitter.late);
            return piece.dots.size() == 0 || take_(piece.dots);
        }

     private:
        Cutter cutter_;
        const TakePiece& take_;
    };
    if (request.count == 0) return true;
    CutStream stream(Cutter(cut, memory_->dropped), take);
    const Traversal traversal(table_, density, request_at(request, cut.scale), cut.early_scale);
    return hand_over_pieces(traversal, *memory_, stream, stop);
}

}  // namespace dapple
