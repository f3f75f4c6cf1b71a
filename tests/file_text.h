#pragma once
// Whole files in and out.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace dapple {

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;  // a piece at a time, where iterators take a character each
    if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
    return text.str();
}

inline void put_text(const std::filesystem::path& file, std::string_view text) {
    std::ofstream(file, std::ios::binary) << text;
}

}  // namespace dapple
