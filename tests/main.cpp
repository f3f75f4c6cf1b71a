#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "tests/places.h"

namespace dapple {

std::string dapple_program() {
    return DAPPLE_PROGRAM;
}

std::string lab_program() {
    return DAPPLE_LAB;
}

std::filesystem::path source_folder() {
    return DAPPLE_SOURCE;
}

}  // namespace dapple
