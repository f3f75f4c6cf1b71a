#pragma once
// dapple testsheet: a page to plot, from which the dot gain of pens is read off.

#include <filesystem>

#include "core/drawing/settings.h"

namespace CLI {
class App;
}

namespace dapple {

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class TestSheetCommand {
 public:
    explicit TestSheetCommand(CLI::App& program);
    TestSheetCommand(const TestSheetCommand&) = delete;
    TestSheetCommand& operator=(const TestSheetCommand&) = delete;

 private:
    void save() const;

    DrawingSettings drawing_;
    SavingChoice saving_;
    std::filesystem::path output_;
};

}  // namespace dapple
