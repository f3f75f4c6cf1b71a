#include "lab/search/rules.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "lab/search/criteria.h"

namespace dapple {

namespace {

constexpr int kRules = 8 * 8 * 8 * 8;
constexpr int kRuleLags = 64;
// Enough for a bound from below: rules that repeat mostly do so nearby.
constexpr int kNearLags = 8;
constexpr std::size_t kRulesAtOnce = 16;

Rule rule_at(int digits) {
    Rule rule;
    for (int q = 3; q >= 0; --q, digits /= 8)
        rule.child[static_cast<std::size_t>(q)].index = static_cast<std::uint8_t>(digits % 8);
    return rule;
}

int digits_of(const Rule& rule) {
    int digits = 0;
    for (const Orientation g : rule.child) digits = 8 * digits + g.index;
    return digits;
}

bool is_first_of_its_kind(const Rule& rule) {
    return std::ranges::none_of(all_orientations(),
                                [&](Orientation g) { return digits_of(turned(rule, g)) < digits_of(rule); });
}

RuleMarks marks_of(const Rule& rule, int lags) {
    const std::vector<double> at_lags = orientation_coincidence(rule, lags);
    const auto highest = std::ranges::max_element(at_lags);
    double sum = 0;
    for (const double share : at_lags) sum += share;
    return {rule, *highest, static_cast<int>(highest - at_lags.begin()) + 1, sum / lags};
}

// The key of the order: what is equal but for rounding is equal.
std::pair<double, int> repetition(const RuleMarks& marks) {
    return {std::round(marks.coincidence * 1e9), digits_of(marks.rule)};
}

void sort_by_repetition(std::span<RuleMarks> rules) {
    std::ranges::sort(rules, {}, repetition);
}

}  // namespace

Rule turned(const Rule& rule, Orientation g) {
    Rule image;
    for (int q = 0; q < 4; ++q)
        image.child[apply_to_quadrant(g, q)] = compose(compose(g, rule.child[q]), inverse(g));
    return image;
}

std::vector<RuleMarks> best_rules(std::size_t count) {
    std::vector<RuleMarks> rules;
    for (int digits = 0; digits < kRules; ++digits) {
        if (is_first_of_its_kind(rule_at(digits))) rules.push_back({.rule = rule_at(digits)});
    }
    tbb::parallel_for(std::size_t{0}, rules.size(),
                      [&](std::size_t i) { rules[i] = marks_of(rules[i].rule, kNearLags); });
    sort_by_repetition(rules);

    // More lags only raise the highest. So once the next rule is behind `count` others, all that follow are.
    std::size_t seen = 0;
    count = std::min(count, rules.size());
    while (seen < rules.size() && (seen < count || repetition(rules[seen]) < repetition(rules[count - 1]))) {
        const std::size_t end = std::min(rules.size(), seen + kRulesAtOnce);
        tbb::parallel_for(seen, end, [&](std::size_t i) { rules[i] = marks_of(rules[i].rule, kRuleLags); });
        seen = end;
        sort_by_repetition(std::span(rules).first(seen));
    }
    rules.resize(count);
    return rules;
}

}  // namespace dapple
