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

/// A product: 2*210, 2*8in. Of lengths the last factor alone is one.
std::optional<double> product_of(std::string_view term, TypedKind kind, LengthUnit bare) {
    double product = 1;
    for (std::size_t star = term.find('*'); star != std::string_view::npos; star = term.find('*')) {
        const std::optional<double> factor = quantity_of(trimmed(term.substr(0, star)));
        if (!factor) return std::nullopt;
        product *= *factor;
        term.remove_prefix(star + 1);
    }
    term = trimmed(term);
    const std::optional<double> last =
        kind == TypedKind::length ? millimetres_of(term, bare) : quantity_of(term);
    if (!last) return std::nullopt;
    return product * *last;
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
