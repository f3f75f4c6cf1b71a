#include "core/text/shown_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

namespace dapple {
namespace {

bool is_safe(std::uint32_t code) {
    if (code < 0x20 || (code >= 0x7f && code < 0xa0)) return false;
    const bool turns = code == 0x200e || code == 0x200f || code == 0x61c ||
                       (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    const bool ends_line = code == 0x2028 || code == 0x2029;
    return !turns && !ends_line && code != 0xfeff;
}

std::string written_out(std::uint32_t code) {
    if (code == '\n') return "\\n";
    if (code == '\r') return "\\r";
    if (code == '\t') return "\\t";
    return code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
}

// The byte that "\xff" at the beginning stands for.
std::optional<unsigned char> written_byte(std::string_view text) {
    unsigned char byte = 0;
    if (text.size() < 4 || !text.starts_with("\\x")) return std::nullopt;
    const auto [end, failed] = std::from_chars(text.data() + 2, text.data() + 4, byte, 16);
    if (failed != std::errc() || end != text.data() + 4) return std::nullopt;
    return byte;
}

}  // namespace

Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return {byte(0), 1};
    const std::size_t bytes = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < bytes) return {};
    std::uint32_t code = byte(0) & (0x7fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3fu);
    }
    const std::uint32_t least = bytes == 4 ? 0x10000 : bytes == 3 ? 0x800 : 0x80;
    if (code < least || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
    return {code, bytes};
}

std::string printable(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (character.bytes == 0) {
            result += written_out(static_cast<unsigned char>(text.front()));
            text.remove_prefix(1);
            continue;
        }
        if (is_safe(character.code))
            result += text.substr(0, character.bytes);
        else
            result += written_out(character.code);
        text.remove_prefix(character.bytes);
    }
    return result;
}

std::string shortened(std::string_view text) {
    constexpr std::size_t kLongest = 500, kKept = 200;
    // At the beginning of a character.
    const auto cut = [&](std::size_t at) {
        while ((static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) --at;
        return at;
    };
    std::string result;
    while (!text.empty()) {
        const std::size_t size = std::min(text.find(' '), text.size());
        if (size <= kLongest) {
            result += text.substr(0, size);
        } else {
            const std::size_t begin = cut(kKept), end = cut(size - kKept);
            result += text.substr(0, begin);
            result += "...";
            result += text.substr(end, size - end);
        }
        text.remove_prefix(size);
        const std::size_t spaces = std::min(text.find_first_not_of(' '), text.size());
        result += text.substr(0, spaces);
        text.remove_prefix(spaces);
    }
    return result;
}

std::string editable(std::string_view bytes) {
    std::string result;
    while (!bytes.empty()) {
        const auto [code, length] = first_character(bytes);
        const std::string_view one = bytes.substr(0, std::max<std::size_t>(length, 1));
        const bool held = length > 0 && code >= 0x20 && code != 0x7f && code <= 0xffff;
        if (held && !written_byte(bytes))
            result += one;
        else
            for (const char byte : one) result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
        bytes.remove_prefix(one.size());
    }
    return result;
}

std::string bytes_of(std::string_view edited) {
    std::string result;
    while (!edited.empty()) {
        const auto byte = written_byte(edited);
        result += byte ? static_cast<char>(*byte) : edited.front();
        edited.remove_prefix(byte ? 4 : 1);
    }
    return result;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t bytes = first_character(text).bytes;
        if (bytes == 0) return false;
        text.remove_prefix(bytes);
    }
    return true;
}

}  // namespace dapple
