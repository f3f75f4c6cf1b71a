// Feeds a decoder with files that are nearly right. What ends the decoder's process is contained by the
// program, and counted here. KIND is a format as reader_of() names it.

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "tests/fuzz/fuzzing.h"
#include "tests/fuzz/picture_reader.h"

using namespace dapple;

int main(int argc, char** argv) {
    try {
        const FuzzOptions options = fuzz_options(argc, argv);
        const auto format = format_with_reader(options.kind);
        if (!format) throw std::runtime_error(options.kind + ": no format of that name");
        std::freopen("/dev/null", "w", stderr);  // libraries say there what they find wrong
        fuzz(options, [&](const std::string& file) { read_any_picture(*format, file); });
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
