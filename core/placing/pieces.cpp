#include "core/placing/pieces.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>

namespace dapple {

namespace {

constexpr std::size_t kFirstCapacity = 1024;
constexpr float kCloseBounds = 0.95f;
constexpr double kRounding = 0x1p-23;  // of a position in its square, in half sides

// The lowest single number that is not below this: comparing with it, singles compare as with the double.
float not_below(double value) {
    const auto rounded = static_cast<float>(value);
    return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

// A large tile's lists lie in the second cache: the first points are on their way while the square is made
// ready. Inlined always, as GCC takes a function that only prefetches for one without effect.
[[gnu::always_inline]] inline void ask_for_first(const CellPoints& points) {
    constexpr std::size_t kBlocks = 4;
    for (std::size_t i = 0; i < std::min(kBlocks, points.size() / kBlockPoints); ++i) {
        for (const auto& coordinate : points.blocks()[i].at) __builtin_prefetch(coordinate);
    }
}

}  // namespace

SquareEmitter::SquareEmitter(const Traversal& traversal, Dots& dots, EmitterMemory& memory,
                             bool beyond_caches)
    : traversal_(traversal),
      dots_(dots),
      memory_(memory),
      beyond_caches_(beyond_caches),
      kernels_(chosen_kernels()) {
    capacity_ = std::max(kFirstCapacity, dots.x.capacity());
    // Columns are used to their full capacity while dots are appended.
    dots_.resize(capacity_, traversal_.request().thresholds);
    if (traversal_.tail_share()) memory_.tail.resize(std::max(kFirstCapacity, memory_.tail.capacity()));
}

SquareEmitter::~SquareEmitter() {
    dots_.resize(count_, traversal_.request().thresholds);
    memory_.tail.resize(tail_);
}

void SquareEmitter::emit(const Visit& visit, bool ends) {
    if (traversal_.level(visit) < 0) return;
    const CellPoints& points = traversal_.points_of(visit, ends);
    if (points.size() == 0) return;
    ask_for_first(points);
    const DepthScale& scale = traversal_.at_depth(visit.square.depth);
    const Bounds& bounds = visit.density.bounds;
    const double reached = scale.ranks_per_density * bounds.max;
    const SwapAndSigns steps = steps_of(visit.orientation);
    const glm::dvec2 centre = traversal_.corner_in_window(visit.square) + scale.half;
    KernelSquare square;
    square.points = points.blocks();
    square.block_ends = points.block_ends();
    square.swap = steps.swap;
    square.sign_x = steps.negate_x ? -1.0f : 1.0f;
    square.sign_y = steps.negate_y ? -1.0f : 1.0f;
    square.centre_x = static_cast<float>(centre.x);
    square.centre_y = static_cast<float>(centre.y);
    square.half_x = square.sign_x * static_cast<float>(scale.half);
    square.half_y = square.sign_y * static_cast<float>(scale.half);
    square.ranks_per_density = static_cast<float>(scale.ranks_per_density);
    square.none_from = static_cast<float>(reached);
    double certain_per_density = scale.ranks_per_density;
    if (const auto tail = traversal_.tail_share()) {
        certain_per_density *= *tail;
        square.tail_per_density = static_cast<float>(certain_per_density);
    }
    square.certain_below = static_cast<float>(certain_per_density * bounds.min);
    square.threshold_per_rank = scale.threshold_per_rank;
    set_edges(visit, square);
    const KernelOutput output = room_for(points.size() + kKernelPadding);
    CertainPoints certain;
    if (may_be_decided(square, points)) certain = kernels_.place_certain(square, output);
    PlacedCount placed{.dots = certain.count, .tail = 0};
    if (!certain.all) {
        square.first = certain.count;
        const bool across_seam = set_density(visit, square);
        placed = across_seam ? emit_across_seam(square, output) : kernels_.place(square, output);
    }
    count_ += placed.dots;
    tail_ += placed.tail;
}

// Whether the square's bounds may tell which of its points exist, so that nobody has to look the density up.
bool SquareEmitter::may_be_decided(const KernelSquare& square, const CellPoints& points) const {
    if (traversal_.request().thresholds || square.at_edge) return false;
    return square.certain_below > std::min(kCloseBounds * square.none_from, points.last_rank());
}

// Says how the kernel finds the density. True if it can't: a large square at the seam of a map that wraps
// round.
bool SquareEmitter::set_density(const Visit& visit, KernelSquare& square) const {
    const Density& density = traversal_.density();
    const bool looked_up = visit.square.depth >= density.small_depth() && !visit.density.is_patch;
    const PixelRange range = looked_up ? visit.density.pixels : density.pixels_in(visit.square);
    const double side = traversal_.at_depth(visit.square.depth).side_pixels;
    square.pixel_half_x = square.sign_x * side / 2;
    square.pixel_half_y = square.sign_y * side / 2;
    const glm::dvec2 corner = density.corner_pixel();
    const double from_middle = 1 - density.middle();
    square.pixel_centre_x = corner.x + (static_cast<double>(visit.square.x) + 0.5) * side + from_middle;
    square.pixel_centre_y = corner.y + (static_cast<double>(visit.square.y) + 0.5) * side + from_middle;
    square.mixed = density.reading() == Reading::bilinear ? 1 : 0;
    square.picture = density.values().values.data();
    square.width = density.width();
    square.height = density.height();

    // One pixel to spare: a rounded position may lie on the last column, whose right neighbour is then read.
    const bool in_picture = range.first_column >= 0 && range.first_row >= 0 &&
                            range.last_column + 1 < density.width() && range.last_row + 1 < density.height();
    if (range.last_column - range.first_column < 4 && range.last_row - range.first_row < 4) {
        square.source = KernelSquare::Source::block;
        square.first_column = static_cast<int>(range.first_column) + 1;
        square.first_row = static_cast<int>(range.first_row) + 1;
        std::ranges::fill(square.block, 0.0f);
        for (std::int64_t j = range.first_row; j <= range.last_row; ++j) {
            float* const row = square.block + 4 * (j - range.first_row);
            for (std::int64_t i = range.first_column; i <= range.last_column; ++i) {
                row[i - range.first_column] =
                    in_picture ? density.values().row(static_cast<int>(j))[i] : density.pixel(i, j);
            }
        }
        return false;
    }
    square.source = in_picture ? KernelSquare::Source::picture : KernelSquare::Source::clamped;
    return !in_picture && density.sides() == Sides::wrap;
}

// Where the window or the picture ends within the square, only some of its points take part. A window's
// neighbour finds the same number for the edge that they share: sheets join without a lost or doubled dot.
void SquareEmitter::set_edges(const Visit& visit, KernelSquare& square) const {
    const DepthScale& scale = traversal_.at_depth(visit.square.depth);
    const auto x = static_cast<double>(visit.square.x), y = static_cast<double>(visit.square.y);
    const bool in_picture = x >= scale.first_column && y >= scale.first_row && x + 1 <= scale.columns_end &&
                            y + 1 <= scale.rows_end;
    square.at_edge = !visit.in_window || !in_picture;
    if (!square.at_edge) return;
    const auto& [low, high] = traversal_.window();
    const int shift = 61 - visit.square.depth;  // half the side is 2^shift units
    const glm::i64vec2 centre = traversal_.area_of(visit.square).low + (std::int64_t{1} << shift);
    const auto in_window = [shift](std::int64_t edge, std::int64_t middle) {
        return std::ldexp(static_cast<double>(edge - middle), -shift);
    };
    // No position is rounded to one before the page.
    const auto from = [&](std::int64_t window, std::int64_t middle) {
        const double page = in_window(0, middle);
        return not_below(std::max(in_window(window, middle), page > -1 ? page + kRounding : page));
    };
    const auto in_picture_at = [](double edge, double corner) { return 2 * (edge - corner) - 1; };
    square.low_x = from(low.x, centre.x);
    square.low_y = from(low.y, centre.y);
    square.high_x = not_below(std::min(in_window(high.x, centre.x), in_picture_at(scale.columns_end, x)));
    square.high_y = not_below(std::min(in_window(high.y, centre.y), in_picture_at(scale.rows_end, y)));
}

// As the kernels do it, but the pixels beyond the left and right edges are those of the other side.
PlacedCount SquareEmitter::emit_across_seam(const KernelSquare& s, const KernelOutput& output) const {
    const Density& density = traversal_.density();
    PlacedCount placed{.dots = s.first, .tail = 0};
    for (std::size_t i = s.first;; ++i) {
        const PointBlock& points = s.points[i / kBlockPoints];
        const std::size_t at = i % kBlockPoints;
        const float x = points.at[s.swap][at], y = points.at[!s.swap][at], rank = points.rank[at];
        if (!(rank < s.none_from)) return placed;
        const float page_x = s.sign_x * x, page_y = s.sign_y * y;
        if (s.at_edge &&
            !(page_x >= s.low_x && page_x < s.high_x && page_y >= s.low_y && page_y < s.high_y)) {
            continue;
        }
        const double u = s.pixel_centre_x + s.pixel_half_x * x, v = s.pixel_centre_y + s.pixel_half_y * y;
        const double left = std::floor(u), top = std::floor(v);
        const float fx = static_cast<float>(u - left) * s.mixed, fy = static_cast<float>(v - top) * s.mixed;
        const auto column = static_cast<std::int64_t>(left) - 1, row = static_cast<std::int64_t>(top) - 1;
        const float v00 = density.pixel(column, row), v10 = density.pixel(column + 1, row);
        const float v01 = density.pixel(column, row + 1), v11 = density.pixel(column + 1, row + 1);
        const float upper = v00 + (v10 - v00) * fx, lower = v01 + (v11 - v01) * fx;
        const float d = upper + (lower - upper) * fy;
        if (!(d * s.ranks_per_density > rank)) continue;
        output.x[placed.dots] = s.centre_x + s.half_x * x;
        output.y[placed.dots] = s.centre_y + s.half_y * y;
        const float threshold = rank * s.threshold_per_rank;
        if (output.critical) {
            output.threshold[placed.dots] = threshold;
            output.critical[placed.dots] = threshold / d;
        }
        if (output.tail && !(d * s.tail_per_density > rank))
            output.tail[placed.tail++] = {output.first_index + placed.dots, threshold, threshold / d};
        ++placed.dots;
    }
}

KernelOutput SquareEmitter::room_for(std::size_t count) {
    const bool thresholds = traversal_.request().thresholds;
    if (count_ + count > capacity_) {
        capacity_ = std::max(count_ + count, capacity_ + capacity_ / 4);
        dots_.reserve(capacity_, thresholds);  // a vector that is resized may take twice as much
        dots_.resize(capacity_, thresholds);
    }
    const bool with_tail = traversal_.tail_share().has_value();
    if (with_tail && tail_ + count > memory_.tail.size()) {
        memory_.tail.resize(std::max(tail_ + count, tail_ + tail_ / 2));
    }
    return {dots_.x.data() + count_,
            dots_.y.data() + count_,
            thresholds ? dots_.threshold.data() + count_ : nullptr,
            thresholds ? dots_.critical.data() + count_ : nullptr,
            with_tail ? memory_.tail.data() + tail_ : nullptr,
            count_,
            beyond_caches_};
}

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
