// Feeds our own readers of text with files that are nearly right: KIND is tile or points. Fails if one of
// them ended the process: these are all ours.

#include <cstdio>
#include <stdexcept>

#include "core/analysis/point_table.h"
#include "core/tile/tile_file.h"
#include "fuzz/report.h"

using namespace dapple;

namespace {

void read(const std::string& kind, const std::string& text) {
    try {
        if (kind == "tile")
            read_tile(text);
        else
            in_their_own_box(parse_point_table(text), Topology::torus);
    } catch (const std::runtime_error&) {
        // A sentence, as it should be; any other exception ends the process.
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const FuzzOptions options = fuzz_options(argc, argv);
        if (options.kind != "tile" && options.kind != "points")
            throw std::runtime_error(options.kind + ": neither tile nor points");
        return fuzz(options, [&](const std::string& file) { read(options.kind, file); }) > 0 ? 1 : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
