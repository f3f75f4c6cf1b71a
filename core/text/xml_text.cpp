#include "core/text/xml_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "core/text/shown_text.h"

namespace dapple {

namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64_of(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::string_view three = bytes.substr(at, 3);
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 3; ++i)
            bits = bits << 8 | (i < three.size() ? static_cast<unsigned char>(three[i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i)
            text += i <= three.size() ? kLetters[bits >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::string bytes_of_base64(std::string_view text) {
    std::string bytes;
    std::size_t padding = 0;
    while (padding < 2 && text.ends_with('=')) {
        text.remove_suffix(1);
        ++padding;
    }
    if ((text.size() + padding) % 4 != 0) throw std::runtime_error("are not in base64");
    std::uint32_t bits = 0;
    int kept = 0;
    for (const char letter : text) {
        const std::size_t value = kLetters.find(letter);
        if (value == kLetters.npos) throw std::runtime_error("are not in base64");
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        kept += 6;
        if (kept < 8) continue;
        kept -= 8;
        bytes += static_cast<char>(bits >> kept & 255);
    }
    return bytes;
}

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

constexpr std::array<std::pair<char, std::string_view>, 5> kWritten{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

}  // namespace

std::string xml_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto [code, length] = first_character(text);
        const auto written =
            std::ranges::find(kWritten, text.front(), &std::pair<char, std::string_view>::first);
        const bool control = code < 0x20 && code != '\n' && code != '\t';
        if (written != kWritten.end())
            result += written->second;
        else if (length == 0 || control || code == 0xFFFE || code == 0xFFFF)
            result += kReplacement;
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

}  // namespace dapple
