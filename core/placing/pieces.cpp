#include "core/placing/pieces.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace dapple {

namespace {

constexpr std::size_t kMemoriesPerThread = 4;

// The cutting under way.
struct Division {
    const Traversal& traversal;
    double dots;
    Pieces& pieces;
    double in_piece = 0;  // at most so many dots in the piece that is not ended yet

    void add(const Visit& visit) {
        const double side = std::ldexp(1.0, -visit.square.depth);
        const double most =
            kDotsPerScale * traversal.request().scale * visit.density.bounds.max * side * side;
        const bool whole = most <= dots || traversal.ends_at(visit);
        pieces.squares.push_back({visit, whole});
        if (whole) {
            in_piece += most;
            if (in_piece >= dots) end_piece();
            return;
        }
        Visit child;
        for (int q = 0; q < 4; ++q) {
            if (traversal.descend(visit, q, child)) add(child);
        }
    }

    void end_piece() {
        pieces.ends.push_back(pieces.squares.size());
        pieces.most.push_back(in_piece);
        in_piece = 0;
    }
};

bool place_from(const Traversal& traversal, const Visit& visit, SquareEmitter& emitter,
                const std::stop_token& stop) {
    const bool ends = traversal.ends_at(visit);
    emitter.emit(visit, ends);
    if (ends) return true;
    if (stop.stop_requested()) return false;
    Visit child;
    for (int q = 0; q < 4; ++q) {
        if (traversal.descend(visit, q, child) && !place_from(traversal, child, emitter, stop)) return false;
    }
    return true;
}

// One placing on several threads. A piece that is done before its turn waits, and its thread goes on to
// another; who does the piece whose turn it is hands over those that wait behind it too. Meanwhile the others
// place, as far ahead as there are memories.
class PieceQueue {
 public:
    PieceQueue(const Traversal& traversal, const Pieces& pieces, std::vector<PieceMemory>& memories,
               PieceTaker& taker, const std::stop_token& stop)
        : traversal_(traversal), pieces_(pieces), memories_(memories), taker_(taker), stop_(stop) {
        for (PieceMemory& memory : memories_) memory.state = PieceMemory::State::free;
    }

    void work() {
        std::unique_lock lock(mutex_);
        while (PieceMemory* memory = claim(lock)) {
            lock.unlock();
            const bool placed = place(*memory);
            lock.lock();
            if (!placed) end();
            memory->state = PieceMemory::State::waits;
            hand_over(lock);
        }
    }

    // False if it ended early.
    bool finish() const {
        if (error_) std::rethrow_exception(error_);
        return !ended_;
    }

 private:
    // A free memory for the next piece; none if there are no more pieces or it ended.
    PieceMemory* claim(std::unique_lock<std::mutex>& lock) {
        const auto is_free = [](const PieceMemory& m) { return m.state == PieceMemory::State::free; };
        while (!ended_ && next_ < pieces_.ends.size()) {
            // Somebody places the piece whose turn it is, or hands pieces over, or it could not lie before
            // next_: this wait ends.
            const auto memory = std::ranges::find_if(memories_, is_free);
            if (memory != memories_.end()) {
                memory->state = PieceMemory::State::is_placed;
                memory->piece = next_++;
                return &*memory;
            }
            freed_.wait(lock);
        }
        return nullptr;
    }

    // The taker is called without the lock, by one thread at a time.
    void hand_over(std::unique_lock<std::mutex>& lock) {
        if (handing_over_) return;  // who does so comes to this piece too
        handing_over_ = true;
        const auto is_next = [this](const PieceMemory& m) {
            return m.state == PieceMemory::State::waits && m.piece == turn_;
        };
        for (auto m = memories_.begin();
             !ended_ && (m = std::ranges::find_if(memories_, is_next)) != memories_.end();) {
            ++turn_;
            lock.unlock();
            const bool goes_on = take(*m);
            lock.lock();
            if (!goes_on) {
                end();
                break;
            }
            m->state = PieceMemory::State::free;
            freed_.notify_one();
        }
        handing_over_ = false;
    }

    bool take(PieceMemory& memory) {
        try {
            return taker_.take(memory);
        } catch (...) {
            keep_error();
            return false;
        }
    }

    bool place(PieceMemory& memory) {
        try {
            SquareEmitter emitter(traversal_, memory.dots, memory.emitter);
            return place_piece(traversal_, pieces_, memory.piece, emitter, stop_);
        } catch (...) {
            keep_error();
            return false;
        }
    }

    void keep_error() {
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = std::current_exception();
    }

    void end() {
        ended_ = true;
        freed_.notify_all();
    }

    const Traversal& traversal_;
    const Pieces& pieces_;
    std::vector<PieceMemory>& memories_;
    PieceTaker& taker_;
    const std::stop_token& stop_;

    std::mutex mutex_;
    std::condition_variable freed_;
    std::size_t next_ = 0, turn_ = 0;  // the piece to be claimed, and to be handed over
    bool handing_over_ = false;        // somebody does
    bool ended_ = false;               // early
    std::exception_ptr error_;
};

}  // namespace

void divide_into_pieces(const Traversal& traversal, double dots, Pieces& pieces) {
    pieces.squares.clear();
    pieces.ends.clear();
    pieces.most.clear();
    Division division{traversal, dots, pieces};
    Visit root;
    for (int number = 0; number < 4; ++number) {
        if (traversal.start(number, root)) division.add(root);
    }
    if (pieces.squares.empty()) return;
    if (pieces.ends.empty() || pieces.ends.back() < pieces.squares.size()) division.end_piece();
}

bool place_piece(const Traversal& traversal, const Pieces& pieces, std::size_t piece, SquareEmitter& emitter,
                 const std::stop_token& stop) {
    const std::size_t first = piece == 0 ? 0 : pieces.ends[piece - 1];
    for (std::size_t s = first; s < pieces.ends[piece]; ++s) {
        const PieceSquare& square = pieces.squares[s];
        if (!square.with_descendants) {
            emitter.emit(square.visit, false);
        } else if (!place_from(traversal, square.visit, emitter, stop)) {
            return false;
        }
    }
    return !stop.stop_requested();
}

bool hand_over_pieces(const Traversal& traversal, const Pieces& pieces, std::size_t threads,
                      std::vector<PieceMemory>& memories, PieceTaker& taker, const std::stop_token& stop) {
    memories.resize(kMemoriesPerThread * threads);
    PieceQueue queue(traversal, pieces, memories, taker, stop);
    on_threads(threads, [&] { queue.work(); });
    return queue.finish();
}

}  // namespace dapple
