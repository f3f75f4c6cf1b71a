#include "lab/search/kind_links.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dapple {

namespace {

// Eight sums side by side, the same on every processor.
using Lanes = float __attribute__((vector_size(32), aligned(4), may_alias));

constexpr float kFarAway = 1e6f;
constexpr float kSamples = 8;  // of the field, to a spacing
// A point is followed down its predecessors until it moves by less; in spacings.
constexpr float kNegligible = 0.004f;
constexpr float kFieldLag = 0.03f;  // how far a point moves before the field knows of it
constexpr std::int32_t kSpare = 4;  // places of a cell that are kept free
constexpr float kWidthApart = 0.5f;
constexpr float kFadeFrom = 0.5f, kFadeTo = 1.5f;  // from the border, in spacings

const Lanes& lanes(const std::array<float, 8>& a) {
    return *reinterpret_cast<const Lanes*>(a.data());
}

float sum_of(const Lanes& sum) {
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

float squared(glm::vec2 v) {
    return v.x * v.x + v.y * v.y;
}

}  // namespace

SheetGrid::SheetGrid(int sheets, float side, const PairShape& shape)
    : half_(side / 2),
      reach_(static_cast<float>(std::max(4 * shape.tone_width, shape.close_radius))),
      tone_(static_cast<float>(1 / (16 * shape.tone_width * shape.tone_width))),
      close_(static_cast<float>(1 / (shape.close_radius * shape.close_radius))),
      tone_weight_(static_cast<float>(shape.tone_weight)),
      close_weight_(static_cast<float>(shape.close_weight)) {
    side_ = std::max(1, static_cast<int>(side / reach_));
    cells_per_unit_ = static_cast<float>(side_) / side;
    cells_.resize(static_cast<std::size_t>(sheets) * static_cast<std::size_t>((side_ + 2) * (side_ + 2)));
    clear();
}

void SheetGrid::clear() {
    for (Cell& cell : cells_) {
        cell.count = 0;
        for (auto& x : cell.x) x.fill(kFarAway);
        for (auto& y : cell.y) y.fill(kFarAway);
        for (auto& w : cell.weight) w.fill(0);
    }
}

std::size_t SheetGrid::cell_of(std::uint32_t sheet, glm::vec2 p) const {
    const int x = std::clamp(static_cast<int>((p.x + half_) * cells_per_unit_), 0, side_ - 1);
    const int y = std::clamp(static_cast<int>((p.y + half_) * cells_per_unit_), 0, side_ - 1);
    return static_cast<std::size_t>(sheet) * static_cast<std::size_t>((side_ + 2) * (side_ + 2)) +
           static_cast<std::size_t>((y + 1) * (side_ + 2) + x + 1);
}

bool SheetGrid::fits(std::uint32_t sheet, glm::vec2 p) const {
    return cells_[cell_of(sheet, p)].count + kSpare < kLanes * kBlocks;
}

void SheetGrid::insert(std::uint32_t sheet, glm::vec2 p, float weight, std::uint32_t name) {
    Cell& cell = cells_[cell_of(sheet, p)];
    if (cell.count == kLanes * kBlocks)
        throw std::runtime_error("too many points of a tile lie in one place");
    const auto i = static_cast<std::size_t>(cell.count++);
    cell.x[i / kLanes][i % kLanes] = p.x;
    cell.y[i / kLanes][i % kLanes] = p.y;
    cell.weight[i / kLanes][i % kLanes] = weight;
    cell.name[i] = name;
}

void SheetGrid::remove(std::uint32_t sheet, glm::vec2 p, std::uint32_t name) {
    Cell& cell = cells_[cell_of(sheet, p)];
    std::size_t i = 0;
    while (cell.name[i] != name) ++i;
    const auto last = static_cast<std::size_t>(--cell.count);
    cell.x[i / kLanes][i % kLanes] = cell.x[last / kLanes][last % kLanes];
    cell.y[i / kLanes][i % kLanes] = cell.y[last / kLanes][last % kLanes];
    cell.weight[i / kLanes][i % kLanes] = cell.weight[last / kLanes][last % kLanes];
    cell.name[i] = cell.name[last];
    cell.x[last / kLanes][last % kLanes] = kFarAway;
}

float SheetGrid::pair(float d2) const {
    const float t = std::max(0.0f, 1 - d2 * tone_), s = std::max(0.0f, 1 - d2 * close_);
    const float t2 = t * t, t4 = t2 * t2;
    return tone_weight_ * (t4 * t4) + close_weight_ * (s * s);
}

float SheetGrid::energy(std::uint32_t sheet, glm::vec2 p) const {
    const std::size_t width = static_cast<std::size_t>(side_) + 2, centre = cell_of(sheet, p);
    const Lanes zero{};
    Lanes tone_sum{}, close_sum{};
    for (std::size_t row = centre - width; row <= centre + width; row += width) {
        for (std::size_t at = row - 1; at <= row + 1; ++at) {
            const Cell& cell = cells_[at];
            for (int b = 0; b * kLanes < cell.count; ++b) {
                const auto block = static_cast<std::size_t>(b);
                const Lanes dx = lanes(cell.x[block]) - p.x, dy = lanes(cell.y[block]) - p.y;
                const Lanes d2 = dx * dx + dy * dy;
                const Lanes weight = lanes(cell.weight[block]);
                Lanes t = 1.0f - d2 * tone_;
                t = t > zero ? t : zero;
                t = t * t;
                t = t * t;
                Lanes s = 1.0f - d2 * close_;
                s = s > zero ? s : zero;
                tone_sum += weight * (t * t);
                close_sum += weight * (s * s);
            }
        }
    }
    return sum_of(tone_weight_ * tone_sum + close_weight_ * close_sum);
}

void SheetGrid::find_near(std::uint32_t sheet, glm::vec2 p, float radius,
                          std::vector<std::uint32_t>& names) const {
    names.clear();
    const std::size_t low = cell_of(sheet, p - radius), high = cell_of(sheet, p + radius);
    const std::size_t width = static_cast<std::size_t>(side_) + 2;
    const std::size_t columns = (high - low) % width;
    for (std::size_t row = low; row <= high; row += width) {
        for (std::size_t at = row; at <= row + columns; ++at) {
            const Cell& cell = cells_[at];
            for (std::size_t i = 0; i < static_cast<std::size_t>(cell.count); ++i) {
                const float dx = cell.x[i / kLanes][i % kLanes] - p.x,
                            dy = cell.y[i / kLanes][i % kLanes] - p.y;
                if (dx * dx + dy * dy <= radius * radius) names.push_back(cell.name[i]);
            }
        }
    }
}

KindLinks::KindLinks(const NextKinds& next, std::span<const char> letters,
                     std::span<const std::uint32_t> successors, const PairShape& shape)
    : points_(static_cast<std::uint32_t>(letters.size() / next.size())),
      kinds_(static_cast<std::uint32_t>(next.size())),
      side_(std::sqrt(static_cast<float>(points_))),
      stretch_(std::sqrt(static_cast<float>(kinds_))),
      own_(static_cast<int>(kinds_), side_, shape),
      all_(1, side_ * stretch_,
           {.tone_width = static_cast<double>(kWidthApart),
            .close_weight = 0,
            .close_radius = 1,
            .tone_weight = 1}),
      field_side_(static_cast<int>(side_ * kSamples) + 3),
      successor_(successors.begin(), successors.end()),
      predecessors_(letters.size(), {kNone, kNone, kNone, kNone}),
      quadrant_(letters.size()),
      position_(letters.size(), glm::vec2(0)) {
    for (std::uint32_t i = 0; i < size(); ++i) {
        quadrant_[i] = static_cast<std::uint8_t>(letters[i] - '0');
        predecessors_[successor_[i]][quadrant_[i]] = i;
    }
    refresh();
}

glm::vec2 KindLinks::image_of_successor(std::uint32_t i) const {
    const glm::vec2 p = position_[successor_[i]];
    const int q = quadrant_[i];
    return {0.5f * p.x + (q & 1 ? 0.25f : -0.25f) * side_, 0.5f * p.y + (q & 2 ? 0.25f : -0.25f) * side_};
}

float KindLinks::weight_at(glm::vec2 p) const {
    const float from_border = side_ / 2 - std::max(std::abs(p.x), std::abs(p.y));
    const float t = std::clamp((from_border - kFadeFrom) / (kFadeTo - kFadeFrom), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

bool KindLinks::near_border(glm::vec2 p) const {
    return side_ / 2 - std::max(std::abs(p.x), std::abs(p.y)) < own_.reach();
}

float KindLinks::field_at(glm::vec2 p) const {
    if (!near_border(p)) return 0;
    const float u = (p.x + side_ / 2) * kSamples, v = (p.y + side_ / 2) * kSamples;
    const int i = std::clamp(static_cast<int>(u), 0, field_side_ - 2);
    const int j = std::clamp(static_cast<int>(v), 0, field_side_ - 2);
    const float fx = u - static_cast<float>(i), fy = v - static_cast<float>(j);
    const float* const at = &field_[static_cast<std::size_t>(j * field_side_ + i)];
    const float* const above = at + field_side_;
    return (at[0] * (1 - fx) + at[1] * fx) * (1 - fy) + (above[0] * (1 - fx) + above[1] * fx) * fy;
}

void KindLinks::add_to_field(glm::vec2 p, float sign) {
    if (!near_border(p)) return;
    const float reach = own_.reach(), weight = sign / static_cast<float>(kinds_);
    for (int oy = -1; oy <= 1; ++oy) {
        for (int ox = -1; ox <= 1; ++ox) {
            if (ox == 0 && oy == 0) continue;
            const float u = p.x + (static_cast<float>(ox) + 0.5f) * side_,
                        v = p.y + (static_cast<float>(oy) + 0.5f) * side_;
            const int first_i = std::max(0, static_cast<int>(std::ceil((u - reach) * kSamples)));
            const int last_i =
                std::min(field_side_ - 1, static_cast<int>(std::floor((u + reach) * kSamples)));
            const int first_j = std::max(0, static_cast<int>(std::ceil((v - reach) * kSamples)));
            const int last_j =
                std::min(field_side_ - 1, static_cast<int>(std::floor((v + reach) * kSamples)));
            for (int j = first_j; j <= last_j; ++j) {
                const float dy = static_cast<float>(j) / kSamples - v;
                float* const row = &field_[static_cast<std::size_t>(j * field_side_)];
                for (int i = first_i; i <= last_i; ++i) {
                    const float dx = static_cast<float>(i) / kSamples - u;
                    row[i] += weight * own_.pair(dx * dx + dy * dy);
                }
            }
        }
    }
}

void KindLinks::refresh() {
    for (int round = 0; round < 40; ++round) {
        for (std::uint32_t i = 0; i < size(); ++i) position_[i] = image_of_successor(i);
    }
    own_.clear();
    all_.clear();
    field_.assign(static_cast<std::size_t>(field_side_ * field_side_), 0.0f);
    in_field_ = position_;
    energy_ = 0;
    for (std::uint32_t i = 0; i < size(); ++i) {
        const glm::vec2 p = position_[i];
        energy_ += static_cast<double>(own_.energy(kind_of(i), p));
        own_.insert(kind_of(i), p, 1, i);
        const float w = weight_at(p);
        if (w > 0 && apart_ > 0) {
            energy_ += static_cast<double>(apart_ * w * all_.energy(0, p * stretch_));
            all_.insert(0, p * stretch_, w, i);
        }
        add_to_field(p, 1);
    }
    for (std::uint32_t i = 0; i < size(); ++i) energy_ += 0.5 * static_cast<double>(field_at(position_[i]));
}

bool KindLinks::set_apart(double apart) {
    SheetGrid together = all_;
    together.clear();
    for (std::uint32_t i = 0; i < size(); ++i) {
        const glm::vec2 p = position_[i];
        if (weight_at(p) == 0) continue;
        if (!together.fits(0, p * stretch_)) return false;
        together.insert(0, p * stretch_, 1, i);
    }
    apart_ = static_cast<float>(apart);
    refresh();
    return true;
}

double KindLinks::change_of(std::uint32_t p, glm::vec2 to) const {
    const glm::vec2 from = position_[p];
    const float between = squared(to - from);
    float change = own_.energy(kind_of(p), to) - own_.pair(between) - own_.energy(kind_of(p), from) +
                   own_.pair(0) + field_at(to) - field_at(from);
    if (apart_ == 0) return static_cast<double>(change);
    const float w_from = weight_at(from), w_to = weight_at(to);
    if (w_to > 0) {
        change += apart_ * w_to *
                  (all_.energy(0, to * stretch_) - w_from * all_.pair(between * stretch_ * stretch_));
    }
    if (w_from > 0) change -= apart_ * w_from * (all_.energy(0, from * stretch_) - w_from * all_.pair(0));
    return static_cast<double>(change);
}

void KindLinks::put(std::uint32_t p, glm::vec2 to) {
    const glm::vec2 from = position_[p];
    own_.remove(kind_of(p), from, p);
    if (apart_ > 0 && weight_at(from) > 0) all_.remove(0, from * stretch_, p);
    position_[p] = to;
    own_.insert(kind_of(p), to, 1, p);
    if (const float w = weight_at(to); apart_ > 0 && w > 0) all_.insert(0, to * stretch_, w, p);
}

void KindLinks::link(std::uint32_t a, std::uint32_t from, std::uint32_t to) {
    successor_[a] = to;
    predecessors_[from][quadrant_[a]] = kNone;
    predecessors_[to][quadrant_[a]] = a;
}

bool KindLinks::undo(std::uint32_t a, std::uint32_t from, std::uint32_t to) {
    link(a, to, from);
    for (; !journal_.empty(); journal_.pop_back()) put(journal_.back().point, journal_.back().from);
    return false;
}

bool KindLinks::step(Random& random, double temperature, double radius) {
    const std::uint32_t a = random.below(size()), from = successor_[a];
    own_.find_near(kind_of(from), position_[from], static_cast<float>(radius), near_);
    const std::uint32_t to = near_[random.below(near_.size())];
    // Exchanging the successors of two points of one quadrant would only exchange their names.
    if (predecessors_[to][quadrant_[a]] != kNone) return false;

    const double allowed = -temperature * std::log(1 - random.unit());
    // Further down the predecessors points move less: a move that is far too dear by then stays so.
    const double hopeless = allowed + 0.1 + 2 * temperature;
    link(a, from, to);
    journal_.clear();
    queue_.assign(1, a);
    double change = 0;
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        const std::uint32_t p = queue_[k];
        const glm::vec2 target = image_of_successor(p);
        if (squared(target - position_[p]) < kNegligible * kNegligible) continue;
        if (!own_.fits(kind_of(p), target) || (apart_ > 0 && !all_.fits(0, target * stretch_)))
            return undo(a, from, to);
        change += change_of(p, target);
        if (change > hopeless) return undo(a, from, to);
        journal_.push_back({p, position_[p]});
        put(p, target);
        for (const std::uint32_t before : predecessors_[p]) {
            if (before != kNone) queue_.push_back(before);
        }
    }
    if (change > allowed) return undo(a, from, to);
    energy_ += change;
    for (const Moved& moved : journal_) {
        glm::vec2& known = in_field_[moved.point];
        const glm::vec2 now = position_[moved.point];
        if (squared(now - known) < kFieldLag * kFieldLag || (!near_border(known) && !near_border(now)))
            continue;
        add_to_field(known, -1);
        add_to_field(now, 1);
        known = now;
    }
    return true;
}

}  // namespace dapple
