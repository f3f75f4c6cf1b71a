#include "app/viewer/widgets/typed_value.h"

#include <algorithm>

#include "core/text/length.h"
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

}  // namespace

std::optional<double> typed_value(std::string_view text, TypedKind kind) {
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
        const std::optional<double> value =
            kind == TypedKind::length ? millimetres_of(term) : quantity_of(term);
        if (!value) return std::nullopt;
        sum += sign * *value;
    }
    return sum;
}

}  // namespace dapple
