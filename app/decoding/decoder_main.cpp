// A decoder: a program of its own, so that what a hostile file does to a library happens there.
//
//     dapple-decode READER MOST-PIXELS over-paper|as-is
//
// reads the file that is its descriptor 3, which is in the format of OpenImageIO's reader of that name, and
// writes it into standard output as image_pipe.h says.

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "app/decoding/decode.h"
#include "app/decoding/decoder_limits.h"
#include "app/decoding/image_pipe.h"

int main(int argc, char** argv) {
    using namespace dapple;
    constexpr int kFile = 3, kUsage = 2;
    const auto format = argc == 4 ? format_with_reader(argv[1]) : std::nullopt;
    if (!format) return kUsage;
    const DecodeRequest request{.over_paper = std::string_view(argv[3]) == "over-paper",
                                .most_pixels = std::strtoll(argv[2], nullptr, 10)};
    limit_decoder();
    ImagePipe pipe(STDOUT_FILENO);
    try {
        try {
            decode(kFile, *format, request, &limit_decoder_to, pipe);
            pipe.finish();
        } catch (const TooManyPixels& error) {
            pipe.fail(error.what(), true);
        } catch (const std::bad_alloc&) {
            pipe.fail("needs more memory to decode than a picture of its size should", false);
        } catch (const std::exception& error) {
            pipe.fail(error.what(), false);
        }
    } catch (const std::exception&) {
        // Whoever asked for the picture has gone.
    }
    // At once: hundreds of libraries would take their time to say goodbye.
    ::_exit(0);
}
