#include "core/placing/placer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <shared_mutex>

#include "core/placing/placer_memory.h"

namespace dapple {

namespace {

constexpr double kPieceDots = 32768;       // 256 KiB: leaves most of a core's own cache to the density
constexpr double kLeastPieceDots = 1024;   // smaller ones are not worth handing over
constexpr double kPiecesPerThread = 8;     // so that threads finish together
constexpr double kWorthSharing = 1 << 14;  // dots; fewer are placed before another thread has woken up

// Room for what is expected, so that columns need not grow, which takes twice the memory.
void reserve(Dots& dots, double expected, bool appearance) {
    const auto room = static_cast<std::size_t>(std::min(expected * 1.01, 1e12)) + 4096;
    if (dots.x.capacity() >= room && (!appearance || dots.critical.capacity() >= room)) return;
    dots = {};
    dots.reserve(room, appearance);
}

// Puts pieces into columns, each thread its own.
class Collector : public PieceTaker {
 public:
    Collector(Dots& dots, LateDots& late, bool appearance)
        : dots_(dots), late_(late), appearance_(appearance) {
        late_.clear();
        dots_.resize(dots_.x.capacity(), appearance_);
    }

    bool take_in_turn(PieceMemory& piece) override {
        piece.start = count_;
        count_ += piece.dots.size();
        for (const LateDot& dot : piece.emitter.late) {
            late_.push_back({piece.start + dot.index, dot.threshold, dot.critical});
        }
        if (count_ > dots_.x.size()) {
            const std::unique_lock nobody_copies(copying_);
            dots_.resize(std::max(count_, dots_.x.size() + dots_.x.size() / 2), appearance_);
        }
        return true;
    }

    void take_beside(const PieceMemory& piece) override {
        const std::shared_lock copies(copying_);
        copy(piece.dots.x, dots_.x, piece.start);
        copy(piece.dots.y, dots_.y, piece.start);
        copy(piece.dots.threshold, dots_.threshold, piece.start);
        copy(piece.dots.critical, dots_.critical, piece.start);
    }

    void finish() { dots_.resize(count_, appearance_); }

 private:
    static void copy(const FloatBuffer& from, FloatBuffer& to, std::size_t at) {
        std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(at));
    }

    Dots& dots_;
    LateDots& late_;
    const bool appearance_;
    std::size_t count_ = 0;
    std::shared_mutex copying_;
};

// Gives each piece to a function.
class Stream : public PieceTaker {
 public:
    explicit Stream(const TakePiece& take) : take_(take) {}
    bool take_in_turn(PieceMemory& piece) override { return piece.dots.size() == 0 || take_(piece.dots); }

 private:
    const TakePiece& take_;
};

double expected_dots(const Traversal& traversal) {
    return 16 * traversal.request().scale * traversal.density().mean();
}

}  // namespace

std::size_t threads_for(int wanted) {
    return static_cast<std::size_t>(wanted > 0 ? wanted : tbb::this_task_arena::max_concurrency());
}

bool hand_over_pieces(const Traversal& traversal, PlacerMemory& memory, PieceTaker& taker,
                      const std::stop_token& stop) {
    const std::size_t threads = threads_for(traversal.request().threads);
    const double share = expected_dots(traversal) / (kPiecesPerThread * static_cast<double>(threads));
    divide_into_pieces(traversal, std::clamp(share, kLeastPieceDots, kPieceDots), memory.pieces);
    return place_pieces(traversal, memory.pieces, threads, memory.piece_memories, taker, stop);
}

bool place_columns(const Traversal& traversal, PlacerMemory& memory, Dots& dots,
                   const std::stop_token& stop) {
    const bool appearance = traversal.request().appearance, whole_page = traversal.root().in_window;
    const double expected = expected_dots(traversal);
    if (whole_page) reserve(dots, expected, appearance);
    if (threads_for(traversal.request().threads) == 1 || (whole_page && expected < kWorthSharing)) {
        SquareEmitter emitter(traversal, dots, memory.emitter);
        return place_all(traversal, emitter, stop);
    }
    Collector collector(dots, memory.emitter.late, appearance);
    const bool done = hand_over_pieces(traversal, memory, collector, stop);
    collector.finish();
    return done;
}

Placer::Placer(PlacingTable table) : table_(std::move(table)), memory_(std::make_unique<PlacerMemory>()) {}
Placer::Placer(Placer&&) noexcept = default;
Placer& Placer::operator=(Placer&&) noexcept = default;
Placer::~Placer() = default;

bool Placer::place(const Density& density, const PlacingRequest& request, Dots& dots, std::stop_token stop) {
    return place_columns(Traversal(table_, density, request), *memory_, dots, stop);
}

bool Placer::place_in_pieces(const Density& density, const PlacingRequest& request, const TakePiece& take,
                             std::stop_token stop) {
    Stream stream(take);
    return hand_over_pieces(Traversal(table_, density, request), *memory_, stream, stop);
}

}  // namespace dapple
