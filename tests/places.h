#pragma once
// Where a build and its sources lie. Known to main.cpp alone, so that all else compiles to the same in every
// folder.

#include <filesystem>
#include <string>

namespace dapple {

/// The program that is tested; built with the tests that start it.
std::string dapple_program();
/// The laboratory's.
std::string lab_program();

std::filesystem::path source_folder();

}  // namespace dapple
