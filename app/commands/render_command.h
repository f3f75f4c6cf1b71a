#pragma once
// dapple render: its options, and what they come to.

#include <filesystem>
#include <vector>

#include "app/commands/render.h"

namespace CLI {
class App;
}

namespace dapple {

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class RenderCommand {
 public:
    explicit RenderCommand(CLI::App& program);
    RenderCommand(const RenderCommand&) = delete;
    RenderCommand& operator=(const RenderCommand&) = delete;

 private:
    void add_input_options(CLI::App& command);
    void add_output_options(CLI::App& command);
    void add_saving_options(CLI::App& command);
    void run(const CLI::App& command);

    RenderOptions options_;
    std::vector<std::filesystem::path> pictures_;  // where there are several
    int jobs_ = 0;
    bool automatic_tone_ = true;  // before the options say another
};

}  // namespace dapple
