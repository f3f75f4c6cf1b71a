// Feeds our own readers of text with files that are nearly right: KIND is tile or points. Fails if one of
// them ended the process: these are all ours.

#include <cstdio>
#include <stdexcept>

#include "fuzz/readers.h"
#include "fuzz/report.h"

using namespace dapple;

int main(int argc, char** argv) {
    try {
        const FuzzOptions options = fuzz_options(argc, argv);
        if (options.kind != "tile" && options.kind != "points")
            throw std::runtime_error(options.kind + ": neither tile nor points");
        return fuzz(options, options.kind == "tile" ? &read_any_tile : &read_any_points) > 0 ? 1 : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
