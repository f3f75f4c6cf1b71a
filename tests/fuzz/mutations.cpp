#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace dapple {
namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t most, Random& random) {
    return most == 0 ? 0 : static_cast<std::size_t>(random() % most);
}

// Headers are at the beginning, so half of all changes are there.
std::size_t place(const std::string& bytes, Random& random) {
    constexpr std::size_t kHeader = 128;
    const bool early = random() % 2 == 0;
    return below(early ? std::min(bytes.size(), kHeader) : bytes.size(), random);
}

void put_number(std::string& bytes, Random& random) {
    constexpr std::array<std::uint64_t, 14> kExtremes{
        0,      1,      2,       0x7f,       0x80,       0xff,       0x7fff,
        0x8000, 0xffff, 0x10000, 0x7fffffff, 0x80000000, 0xffffffff, 0x7fffffffffffffff};
    const std::uint64_t value = kExtremes[below(kExtremes.size(), random)];
    const std::size_t width = std::size_t{1} << below(4, random), at = place(bytes, random);
    const bool big_endian = random() % 2 == 0;
    for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i) {
        const std::size_t shift = 8 * (big_endian ? width - 1 - i : i);
        bytes[at + i] = static_cast<char>(value >> shift);
    }
}

void put_text(std::string& bytes, Random& random) {
    constexpr std::array<std::string_view, 12> kTexts{
        "-1", "0", "99999999999", "1e999", "nan", "-inf", "\n", "\n\n", " ", "#", "1.5", "4294967296"};
    const std::string_view text = kTexts[below(kTexts.size(), random)];
    const std::size_t at = place(bytes, random);
    bytes.replace(at, std::min(below(text.size() + 1, random), bytes.size() - at), text);
}

void change(std::string& bytes, Random& random) {
    const std::size_t at = place(bytes, random);
    const std::size_t length = 1 + below(std::min<std::size_t>(bytes.size() - at, 64), random);
    switch (random() % 9) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ 1 << below(8, random));
            break;
        case 1:
            bytes[at] = static_cast<char>(random());
            break;
        case 2:
        case 3:
            put_number(bytes, random);
            break;
        case 4:
            bytes.erase(at, length);
            break;
        case 5:
            bytes.insert(below(bytes.size(), random), bytes.substr(at, length));
            break;
        case 6:
            for (std::size_t i = at; i < at + length && i < bytes.size(); ++i)
                std::swap(bytes[i], bytes[below(bytes.size(), random)]);
            break;
        case 7:
            put_text(bytes, random);
            break;
        default:
            if (random() % 4 == 0) bytes.resize(at);
    }
}

}  // namespace

std::string mutated(std::string bytes, Random& random) {
    for (std::size_t changes = 1 + below(6, random); changes > 0 && !bytes.empty(); --changes)
        change(bytes, random);
    return bytes;
}

}  // namespace dapple
