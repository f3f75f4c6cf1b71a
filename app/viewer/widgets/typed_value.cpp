#include "app/viewer/widgets/typed_value.h"

#include <algorithm>

#include "core/text/quantity.h"

namespace dapple {
namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

// Where the first term ends: at the next sign, but not at the one of 1e-5.
std::size_t end_of_term(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i) {
        const bool sign = text[i] == '+' || text[i] == '-';
        if (sign && text[i - 1] != 'e' && text[i - 1] != 'E') return i;
    }
    return text.size();
}

// 2*210, 8in/2, from the left to the right. One factor is a length where one is wanted, and is not divided
// by.
std::optional<double> product_of(std::string_view term, TypedKind kind, LengthUnit bare) {
    const bool of_lengths = kind == TypedKind::length;
    double product = 1;
    bool has_length = !of_lengths, first = true;
    char sign = '*';
    while (true) {
        const std::size_t end = std::min(term.find_first_of("*/"), term.size());
        const std::string_view factor = trimmed(term.substr(0, end));
        std::optional<double> value = quantity_of(factor);
        if (kind == TypedKind::count && first && !count_of(factor)) return std::nullopt;
        first = false;
        // A number alone may still be the length: the last one is, if no other was.
        const bool last = end == term.size();
        if (of_lengths && sign == '*' && !has_length && (!value || last)) {
            value = millimetres_of(factor, bare);
            has_length = true;
        }
        if (!value || (sign == '/' && *value == 0)) return std::nullopt;
        product = sign == '*' ? product * *value : product / *value;
        if (last) break;
        sign = term[end];
        term.remove_prefix(end + 1);
    }
    if (has_length) return product;
    // 210/2: the numbers come to a length without a unit.
    return product * *millimetres_of("1", bare);
}

}  // namespace

std::optional<double> typed_value(std::string_view text, TypedKind kind, LengthUnit bare) {
    double sum = 0;
    text = trimmed(text);
    if (text.empty()) return std::nullopt;
    while (!text.empty()) {
        std::string_view term = text.substr(0, end_of_term(text));
        text.remove_prefix(term.size());
        double sign = 1;
        if (term.front() == '+' || term.front() == '-') {
            sign = term.front() == '-' ? -1 : 1;
            term.remove_prefix(1);
        }
        term = trimmed(term);
        const std::optional<double> value = product_of(term, kind, bare);
        if (!value) return std::nullopt;
        sum += sign * *value;
    }
    return sum;
}

}  // namespace dapple
