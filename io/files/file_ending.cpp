#include "io/files/file_ending.h"

namespace dapple {

std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string ending_of(const std::filesystem::path& file) {
    return lower_case(file.extension().string());
}

}  // namespace dapple
