#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/placing/dot_order.h"
#include "core/placing/pieces.h"
#include "core/placing/placer.h"

namespace dapple {

namespace {

constexpr double kMaxScale = 1e30;

// The end of an exact drawing lies within this share of the expected scale with near certainty: the count
// strays less than chance would.
double margin(std::uint64_t count) {
    return 0.005 + 2 / std::sqrt(static_cast<double>(count));
}

// With room for every dot of that scale. Ties are told by positions on the page.
PlacingRequest request_at(PlacingRequest request, double scale) {
    request.scale = scale;
    request.origin = PlacingOrigin::page;
    return request;
}

TieKey tie_of(const Dots& dots, const TailDot& dot) {
    return tie_key(dots.x[dot.index], dots.y[dot.index], dot.threshold);
}

// Drops the dots beyond a cut from a drawing that comes whole or piece after piece.
class Cutter {
 public:
    explicit Cutter(const CountCut& cut) : limit_(cut.limit), last_tie_(cut.last_tie) {}

    // Leaves those that were dropped in `tail`.
    void cut(Dots& dots, TailDots& tail) const {
        std::erase_if(tail, [&](const TailDot& dot) {
            return dot.critical < limit_ || (dot.critical == limit_ && tie_of(dots, dot) <= last_tie_);
        });
        if (tail.empty()) return;
        for (FloatBuffer* column : {&dots.x, &dots.y, &dots.threshold, &dots.critical}) {
            if (!column->empty()) drop(tail, *column);
        }
    }

 private:
    static void drop(const TailDots& dropped, FloatBuffer& column) {
        const auto begin = column.begin();
        const auto at = [&](const TailDot& dot) { return begin + static_cast<std::ptrdiff_t>(dot.index); };
        auto to = at(dropped.front());
        for (std::size_t i = 0; i < dropped.size(); ++i) {
            const auto end = i + 1 < dropped.size() ? at(dropped[i + 1]) : column.end();
            to = std::copy(at(dropped[i]) + 1, end, to);
        }
        column.resize(column.size() - dropped.size());
    }

    float limit_;
    TieKey last_tie_;
};

// Where a drawing ends in which `kept` dots of the tail stay; one or more.
template <class Trial>
CountCut cut_among(const Trial& trial, std::uint64_t kept, PlacerMemory& memory) {
    std::vector<float>& criticals = memory.criticals;
    criticals.clear();
    trial.for_each_in_tail([&](float critical, const auto&) { criticals.push_back(critical); });
    const auto last = criticals.begin() + static_cast<std::ptrdiff_t>(kept - 1);
    std::nth_element(criticals.begin(), last, criticals.end());
    CountCut cut;
    cut.limit = *last;
    const auto kept_ties = std::count(criticals.begin(), last, cut.limit);
    std::vector<TieKey>& ties = memory.ties;
    ties.clear();
    trial.for_each_in_tail([&](float critical, const auto& tie) {
        if (critical == cut.limit) ties.push_back(tie());
    });
    std::nth_element(ties.begin(), ties.begin() + kept_ties, ties.end());
    cut.last_tie = ties[static_cast<std::size_t>(kept_ties)];
    return cut;
}

struct PlacedDots {
    std::size_t all = 0, tail = 0;
};

// Tries scales until the end of the drawing lies between two of them. trial.place(scale, tail scale) places
// and says how many dots there are; nothing if stopped. trial.for_each_in_tail() visits the tail's critical
// scales and functions that give their tie keys.
template <class Trial>
std::optional<CountCut> find_end(const Density& density, std::uint64_t count, PlacerMemory& memory,
                                 Trial& trial) {
    if (!(density.mean() > 0)) {
        throw std::runtime_error(
            "there is nothing to draw: the picture is white everywhere; darken it or invert it");
    }
    const double expected = scale_for(density, static_cast<double>(count));
    const double more = 1 + margin(count);
    double tail_scale = expected * std::max(0.0, 2 - more), scale = expected * more;
    // The share by which a count is off, and a little; small drawings grow by steps of a whole tile's ranks.
    const auto step = [more](double share) { return std::clamp(share * more, more, 4.0); };
    while (true) {
        const std::optional<PlacedDots> placed = trial.place(scale, tail_scale);
        if (!placed) return std::nullopt;
        const std::size_t before = placed->all - placed->tail;
        if (placed->all < count) {
            if (scale > kMaxScale) {
                throw std::runtime_error("this many dots do not fit: the picture's dark part is too small");
            }
            tail_scale = scale;
            scale *= step(static_cast<double>(count + 1) / static_cast<double>(placed->all + 1));
            continue;
        }
        if (before < count) {
            CountCut cut = cut_among(trial, count - before, memory);
            cut.scale = scale;
            cut.tail_scale = tail_scale;
            if (cut.limit >= tail_scale) return cut;
        } else {
            scale = tail_scale;
        }
        tail_scale /= step(static_cast<double>(before + 1) / static_cast<double>(count + 1));
    }
}

// A drawing that is kept.
class KeptTrial {
 public:
    KeptTrial(const PlacingTable& table, const Density& density, const PlacingRequest& request,
              PlacerMemory& memory, DotPieces& dots, const std::stop_token& stop)
        : table_(table), density_(density), request_(request), memory_(memory), dots_(dots), stop_(stop) {}

    std::optional<PlacedDots> place(double scale, double tail_scale) {
        const Traversal traversal(table_, density_, request_at(request_, scale), tail_scale);
        if (!keep_dots(traversal, memory_, dots_, stop_)) return std::nullopt;
        PlacedDots placed{.all = dots_.size()};
        for (const EmitterMemory& emitter : memory_.emitters) placed.tail += emitter.tail.size();
        return placed;
    }

    template <class Visit>
    void for_each_in_tail(const Visit& visit) const {
        for (std::size_t i = 0; i < memory_.emitters.size(); ++i) {
            for (const TailDot& dot : memory_.emitters[i].tail)
                visit(dot.critical, [&] { return tie_of(dots_.pieces[i], dot); });
        }
    }

    void cut(const CountCut& at) {
        const Cutter cutter(at);
        for_each_on_threads(memory_.pieces.ends.size(), threads_for(request_.threads),
                            [&](std::size_t i) { cutter.cut(dots_.pieces[i], memory_.emitters[i].tail); });
    }

 private:
    const PlacingTable& table_;
    const Density& density_;
    const PlacingRequest& request_;
    PlacerMemory& memory_;
    DotPieces& dots_;
    const std::stop_token& stop_;
};

// A drawing that nobody keeps, but for what a cut needs of the tail.
class CountedTrial {
 public:
    CountedTrial(const PlacingTable& table, const Density& density, const PlacingRequest& request,
                 PlacerMemory& memory, const std::stop_token& stop)
        : table_(table), density_(density), request_(request), memory_(memory), stop_(stop) {}

    std::optional<PlacedDots> place(double scale, double tail_scale) {
        PlacingRequest whole_page = request_at(request_, scale);
        whole_page.window = {};
        whole_page.thresholds = false;
        const Traversal traversal(table_, density_, whole_page, tail_scale);
        Counter counter(tail_);
        if (!hand_over_dots(traversal, memory_, counter, stop_)) return std::nullopt;
        return PlacedDots{counter.count(), tail_.size()};
    }

    template <class Visit>
    void for_each_in_tail(const Visit& visit) const {
        for (const Tied& dot : tail_) visit(dot.critical, [&] { return dot.tie; });
    }

 private:
    struct Tied {
        float critical;
        TieKey tie;
    };

    class Counter : public PieceTaker {
     public:
        explicit Counter(std::vector<Tied>& tail) : tail_(tail) { tail_.clear(); }
        bool take(PieceMemory& piece) override {
            count_ += piece.dots.size();
            for (const TailDot& dot : piece.emitter.tail)
                tail_.push_back({dot.critical, tie_of(piece.dots, dot)});
            return true;
        }
        std::size_t count() const { return count_; }

     private:
        std::vector<Tied>& tail_;
        std::size_t count_ = 0;
    };

    const PlacingTable& table_;
    const Density& density_;
    const PlacingRequest& request_;
    PlacerMemory& memory_;
    const std::stop_token& stop_;
    std::vector<Tied> tail_;
};

}  // namespace

double CountCut::last_scale() const {
    return std::nextafter(limit, std::numeric_limits<float>::max());  // a dot exists above its critical scale
}

std::optional<CountCut> Placer::find_cut(const Density& density, const PlacingRequest& request,
                                         std::stop_token stop) {
    if (*request.count == 0) return CountCut{};
    CountedTrial trial(*table_, density, request, *memory_, stop);
    return find_end(density, *request.count, *memory_, trial);
}

std::optional<double> Placer::place_count(const Density& density, const PlacingRequest& request,
                                          DotPieces& dots, const std::stop_token& stop) {
    if (*request.count == 0) {
        dots = {};
        return 0.0;
    }
    KeptTrial trial(*table_, density, request, *memory_, dots, stop);
    std::optional<CountCut> cut = request.cut;
    if (!cut && request.window == PageWindow{}) {
        cut = find_end(density, *request.count, *memory_, trial);
        if (!cut) return std::nullopt;
    } else {
        if (!cut) cut = find_cut(density, request, stop);
        if (!cut || !trial.place(cut->scale, cut->tail_scale)) return std::nullopt;
    }
    trial.cut(*cut);
    return cut->last_scale();
}

bool Placer::hand_over_count(const Density& density, const PlacingRequest& request, const TakePiece& take,
                             const std::stop_token& stop) {
    class CutStream : public PieceTaker {
     public:
        CutStream(const CountCut& cut, const TakePiece& take) : cutter_(cut), take_(take) {}
        bool take(PieceMemory& piece) override {
            cutter_.cut(piece.dots, piece.emitter.tail);
            return piece.dots.size() == 0 || take_(piece.dots);
        }

     private:
        Cutter cutter_;
        const TakePiece& take_;
    };
    if (*request.count == 0) return true;
    const std::optional<CountCut> cut = request.cut ? request.cut : find_cut(density, request, stop);
    if (!cut) return false;
    CutStream stream(*cut, take);
    const Traversal traversal(*table_, density, request_at(request, cut->scale), cut->tail_scale);
    return hand_over_dots(traversal, *memory_, stream, stop);
}

}  // namespace dapple
