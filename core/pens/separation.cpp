#include "core/pens/separation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numeric>

#include "core/image/colour.h"
#include "core/maths/portable_math.h"

namespace dapple {
namespace {

constexpr int kLattice = 33;  // colours along each axis, at equal steps of the square root
constexpr double kHueWeight = 1, kStrengthWeight = 0.2;  // over that of luminance
constexpr double kFaint = 0.02;    // strength of a colour, linear, below which its hue matters less and less
constexpr double kSumWeight = 30;  // of the shares' sum being 1 with the bare paper
constexpr double kSmallness = 0.0001;  // of the sum of squares
constexpr int kRounds = 4;             // of making them small
constexpr double kLeastShare = 0.001;  // below it none: a pen's few dots on a page would be specks
constexpr double kLeastPart = 0.025;   // of all pens' shares: one dot among more than 40 would be one, too
constexpr std::size_t kMostUnknowns = kMostPens + 1;

using Vector = std::array<double, kMostUnknowns>;
using Matrix = std::array<Vector, kMostUnknowns>;

// How far apart linear colours are, near a goal: by their luminance, by their hue and by how strong they are.
class ColourErrors {
 public:
    explicit ColourErrors(glm::dvec3 goal) {
        const glm::dvec2 colour = against_grey(goal);
        const double strength = glm::length(colour);
        if (strength > 0) along_ = colour / strength;
        hue_weight_ = std::lerp(kStrengthWeight, kHueWeight, strength / (strength + kFaint));
    }

    /// Their difference is the error.
    glm::dvec3 weighed(glm::dvec3 colour) const {
        const glm::dvec2 own = against_grey(colour);
        return {luminance_of(colour), kStrengthWeight * glm::dot(own, along_),
                hue_weight_ * (own.y * along_.x - own.x * along_.y)};
    }

 private:
    static double luminance_of(glm::dvec3 colour) {
        return 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
    }
    // Red and blue, less the grey of the same luminance.
    static glm::dvec2 against_grey(glm::dvec3 colour) {
        return glm::dvec2(colour.r, colour.b) - luminance_of(colour);
    }

    glm::dvec2 along_{1, 0};
    double hue_weight_;
};

// Solves a symmetric positive definite system of the chosen unknowns, by Cholesky.
void solve_chosen(const Matrix& a, const Vector& b, std::span<const std::size_t> chosen, Vector& x) {
    Matrix l{};
    Vector y{};
    const std::size_t n = chosen.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = a[chosen[i]][chosen[j]];
            for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
            l[i][j] = i == j ? std::sqrt(std::max(sum, 1e-12)) : sum / l[j][j];
        }
        double sum = b[chosen[i]];
        for (std::size_t k = 0; k < i; ++k) sum -= l[i][k] * y[k];
        y[i] = sum / l[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
        double sum = y[i];
        for (std::size_t k = i + 1; k < n; ++k) sum -= l[k][i] * x[chosen[k]];
        x[chosen[i]] = sum / l[i][i];
    }
}

using Chosen = std::array<bool, kMostUnknowns>;

// Non-negative least squares from the normal equations (Lawson & Hanson 1974, chapter 23), from `x` on, of
// the unknowns that may be other than 0.
Vector non_negative_solution(const Matrix& a, const Vector& b, std::size_t n, const Chosen& may, Vector x) {
    Chosen free{};
    for (std::size_t i = 0; i < n; ++i) free[i] = x[i] > 0;
    for (std::size_t round = 0; round < 4 * n; ++round) {
        for (std::size_t inner = 0; inner <= n; ++inner) {
            std::array<std::size_t, kMostUnknowns> chosen{};
            std::size_t count = 0;
            for (std::size_t i = 0; i < n; ++i)
                if (free[i]) chosen[count++] = i;
            Vector z{};
            solve_chosen(a, b, std::span(chosen).first(count), z);
            double way = 1;
            for (std::size_t i = 0; i < n; ++i)
                if (free[i] && z[i] <= 0) way = std::min(way, x[i] / std::max(x[i] - z[i], 1e-300));
            for (std::size_t i = 0; i < n; ++i) {
                if (!free[i]) continue;
                x[i] += way * (z[i] - x[i]);
                if (way < 1 && x[i] <= 1e-12) x[i] = 0, free[i] = false;
            }
            if (way >= 1) break;
        }
        std::size_t best = n;
        double steepest = 1e-10;
        for (std::size_t i = 0; i < n; ++i) {
            if (free[i] || !may[i]) continue;
            double slope = b[i];
            for (std::size_t j = 0; j < n; ++j) slope -= a[i][j] * x[j];
            if (slope > steepest) steepest = slope, best = i;
        }
        if (best == n) break;
        free[best] = true;
    }
    return x;
}

std::size_t lattice_index(int r, int g, int b) {
    return static_cast<std::size_t>((r * kLattice + g) * kLattice + b);
}

}  // namespace

PenMixer::PenMixer(std::span<const Pen> pens, glm::vec3 paper) : paper_(linear_of(paper)) {
    for (const Pen& pen : pens)
        pens_.push_back(linear_of(pen.colour) * (pen.ink == PenInk::transparent ? paper_ : glm::vec3(1)));
}

Shares PenMixer::solve(glm::vec3 aim, double least_part) const {
    const std::size_t n = pens_.size() + 1;  // the bare paper last
    std::array<glm::dvec3, kMostUnknowns> columns{};
    const ColourErrors errors{glm::dvec3(aim)};
    for (std::size_t i = 0; i < pens_.size(); ++i) columns[i] = errors.weighed(glm::dvec3(pens_[i]));
    columns[n - 1] = errors.weighed(glm::dvec3(paper_));
    const glm::dvec3 goal = errors.weighed(glm::dvec3(aim));
    Matrix a{};
    Vector b{};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) a[i][j] = glm::dot(columns[i], columns[j]) + kSumWeight;
        if (i + 1 < n) a[i][i] += kSmallness;
        b[i] = glm::dot(columns[i], goal) + kSumWeight;
    }
    // Iterated Tikhonov regularisation (Engl, Hanke & Neubauer 1996, chapter 5): each round makes small how
    // far the shares are from those of the round before. So a pen that would be seen in place of others, as
    // red in a grey, has hardly a share in the end, while pens that look alike go on sharing evenly. While a
    // pen has too small a part, the one with the smallest goes, and the others make up for it.
    Chosen may{};
    may.fill(true);
    Vector x;
    const auto bare = x.begin() + static_cast<std::ptrdiff_t>(pens_.size());
    while (true) {
        x = {};
        for (int round = 0; round < kRounds; ++round) {
            Vector towards = b;
            for (std::size_t i = 0; i + 1 < n; ++i) towards[i] += kSmallness * x[i];
            x = non_negative_solution(a, towards, n, may, x);
        }
        const auto least = std::min_element(
            x.begin(), bare, [](double one, double other) { return one > 0 && (other <= 0 || one < other); });
        if (*least <= 0 || *least >= least_part * std::accumulate(x.begin(), bare, 0.0)) break;
        may[static_cast<std::size_t>(least - x.begin())] = false;
    }
    const double sum = std::accumulate(x.begin(), std::next(bare), 0.0);
    Shares shares{};
    for (std::size_t i = 0; i < pens_.size(); ++i) {
        const double share = x[i] / std::max(sum, 1e-9);
        if (share >= kLeastShare) shares[i] = static_cast<float>(share);
    }
    return shares;
}

glm::vec3 PenMixer::seen(const Shares& shares) const {
    glm::vec3 colour = paper_;
    for (std::size_t i = 0; i < pens_.size(); ++i) colour += shares[i] * (pens_[i] - paper_);
    return colour;
}

namespace {

// All shares of four pens and the bare paper that look the same: a line, which ends where one of them is 0.
class SameLooks {
 public:
    explicit SameLooks(const PenMixer& mixer) {
        const auto pens = mixer.pens();
        for (std::size_t pen = 1; pen < pens.size(); ++pen)
            if (luminance(pens[pen]) < luminance(pens[black_])) black_ = pen;
        // The black pen's share rises by 1, and the others and the paper make up for it in light and area.
        glm::dmat4 others;
        int column = 0;
        for (std::size_t pen = 0; pen < pens.size(); ++pen)
            if (pen != black_) others[column++] = glm::dvec4(glm::dvec3(pens[pen]), 1);
        others[column] = glm::dvec4(glm::dvec3(mixer.paper()), 1);
        constexpr double kNone = 1e-9;
        if (std::abs(glm::determinant(others)) < kNone) return;
        const glm::dvec4 change = -(glm::inverse(others) * glm::dvec4(glm::dvec3(pens[black_]), 1));
        column = 0;
        for (std::size_t pen = 0; pen < pens.size(); ++pen) way_[pen] = pen == black_ ? 1 : change[column++];
        way_[pens.size()] = change[column];
    }

    // `black` as Separation has it.
    Shares moved(const Shares& shares, double black) const {
        if (way_[black_] == 0) return shares;
        double bare = 1;
        for (std::size_t pen = 0; pen < kPens; ++pen) bare -= shares[pen];
        const double more = black - kUsualBlack;
        double least = -1, most = 1;
        for (std::size_t i = 0; i <= kPens; ++i) {
            const double share = std::max(i < kPens ? double(shares[i]) : bare, 0.0);
            if (way_[i] > 0) least = std::max(least, -share / way_[i]);
            if (way_[i] < 0) most = std::min(most, -share / way_[i]);
        }
        const double step = more > 0 ? most * more / (1 - kUsualBlack) : -least * more / kUsualBlack;
        Shares result = shares;
        for (std::size_t pen = 0; pen < kPens; ++pen)
            result[pen] = std::clamp(static_cast<float>(shares[pen] + step * way_[pen]), 0.0f, 1.0f);
        return result;
    }

    static constexpr std::size_t kPens = 4;

 private:
    std::size_t black_ = 0;
    std::array<double, kPens + 1> way_{};  // the bare paper last; of black 0: there is none
};

}  // namespace

Separation::Separation(std::span<const Pen> pens, glm::vec3 paper, double black) : mixer_(pens, paper) {
    darkest_ = lightest_ = mixer_.paper();
    for (const glm::vec3 pen : mixer_.pens()) {
        // A coloured pen counts as the grey of its luminance, so that it does not colour the whole picture.
        if (luminance(pen) < luminance(darkest_)) darkest_ = glm::vec3(luminance(pen));
        if (luminance(pen) > luminance(lightest_)) lightest_ = glm::vec3(luminance(pen));
    }
    lattice_.resize(kLattice * kLattice * kLattice);
    const auto light = [](int step) {
        const float root = static_cast<float>(step) / (kLattice - 1);
        return root * root;
    };
    tbb::parallel_for(0, kLattice, [&](int r) {
        for (int g = 0; g < kLattice; ++g)
            for (int b = 0; b < kLattice; ++b)
                lattice_[lattice_index(r, g, b)] =
                    mixer_.solve(aim({light(r), light(g), light(b)}), kLeastPart);
    });
    if (black == kUsualBlack || pens.size() != SameLooks::kPens) return;
    const SameLooks line(mixer_);
    for (Shares& shares : lattice_) shares = line.moved(shares, black);
}

Separation Separation::changed(const std::function<Shares(const Shares&)>& change) const {
    Separation other = *this;
    tbb::parallel_for(std::size_t{0}, lattice_.size(),
                      [&](std::size_t i) { other.lattice_[i] = change(lattice_[i]); });
    return other;
}

Shares Separation::shares(glm::vec3 colour) const {
    // Tetrahedra between eight lattice colours: from one corner along the axes in the order of what is left.
    std::array<int, 3> at{};
    std::array<float, 3> rest{};
    for (int i = 0; i < 3; ++i) {
        const float c = colour[i] > 0 ? std::min(colour[i], 1.0f) : 0.0f;  // NaN is dark
        const float place = std::sqrt(c) * (kLattice - 1);
        at[i] = std::min(static_cast<int>(place), kLattice - 2);
        rest[i] = place - static_cast<float>(at[i]);
    }
    std::array<int, 3> axes{0, 1, 2};
    std::ranges::sort(axes, [&](int a, int b) { return rest[a] > rest[b]; });
    Shares result{};
    float before = 1;
    for (int corner = 0; corner <= 3; ++corner) {
        const float next = corner < 3 ? rest[axes[corner]] : 0.0f;
        const Shares& there = lattice_[lattice_index(at[0], at[1], at[2])];
        for (std::size_t k = 0; k < mixer_.pens().size(); ++k) result[k] += (before - next) * there[k];
        before = next;
        if (corner < 3) ++at[axes[corner]];
    }
    return result;
}

glm::vec3 oklab_of(glm::vec3 c) {
    const float l = portable::cbrt(0.4122214708f * c.r + 0.5363325363f * c.g + 0.0514459929f * c.b);
    const float m = portable::cbrt(0.2119034982f * c.r + 0.6806995451f * c.g + 0.1073969566f * c.b);
    const float s = portable::cbrt(0.0883024619f * c.r + 0.2817188376f * c.g + 0.6299787005f * c.b);
    return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
            1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
            0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

namespace {

// Mean squared distance in OKLab between the colours and their mixtures. On a scale from black to the paper,
// not to the pens' own darkest, so that a set without dark pens pays for it.
double error_of(const Palette& pens, std::span<const glm::vec3> colours, glm::vec3 paper) {
    const PenMixer mixer(pens, paper);
    double sum = 0;
    for (const glm::vec3 colour : colours) {
        const glm::vec3 aim = colour * linear_of(paper);
        const glm::vec3 away = oklab_of(mixer.seen(mixer.solve(aim))) - oklab_of(aim);
        sum += glm::dot(away, away);
    }
    return sum;
}

}  // namespace

bool chooses_from_own(const PenChoice& choice) {
    return choice.set == PenSet::automatic && choice.own.size() > static_cast<std::size_t>(choice.automatic);
}

Palette best_pens(std::span<const glm::vec3> colours, std::span<const Pen> candidates, int count,
                  glm::vec3 paper) {
    // The candidate that is best in that place beside the others.
    const auto best_in = [&](const Palette& pens, std::size_t place) {
        std::vector<double> errors(candidates.size(), std::numeric_limits<double>::infinity());
        tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
            Palette with = pens;
            with.resize(std::max(with.size(), place + 1));
            with[place] = {};
            if (std::ranges::find(with, candidates[i].name, &Pen::name) != with.end()) return;
            with[place] = candidates[i];
            errors[i] = error_of(with, colours, paper);
        });
        return candidates[static_cast<std::size_t>(std::ranges::min_element(errors) - errors.begin())];
    };
    Palette chosen;
    const std::size_t wanted = std::min(static_cast<std::size_t>(count), candidates.size());
    while (chosen.size() < wanted) {
        const Pen next = best_in(chosen, chosen.size());
        chosen.push_back(next);
    }
    // Those chosen first did not know the later ones.
    for (std::size_t place = 0; place + 1 < wanted; ++place) chosen[place] = best_in(chosen, place);
    return chosen;
}

}  // namespace dapple
