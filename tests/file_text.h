#pragma once
// Whole files in and out.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace dapple {

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void put_text(const std::filesystem::path& file, std::string_view text) {
    std::ofstream(file, std::ios::binary) << text;
}

}  // namespace dapple
