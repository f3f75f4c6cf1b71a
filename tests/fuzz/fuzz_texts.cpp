// Feeds our own readers of text with files that are nearly right: KIND is tile, points, gcode, pens or
// settings. Fails if one of them ended the process: these are all ours.

#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

#include "tests/fuzz/fuzzing.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/settings_reader.h"

using namespace dapple;

int main(int argc, char** argv) {
    try {
        const FuzzOptions options = fuzz_options(argc, argv);
        const std::map<std::string, void (*)(const std::string&)> readers{{"tile", &read_any_tile},
                                                                          {"points", &read_any_points},
                                                                          {"gcode", &read_any_gcode_template},
                                                                          {"pens", &read_any_pens},
                                                                          {"settings", &read_any_settings}};
        const auto reader = readers.find(options.kind);
        if (reader == readers.end())
            throw std::runtime_error(options.kind + ": neither tile, points, gcode, pens nor settings");
        return fuzz(options, reader->second) > 0 ? 1 : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
