// A decoder: a program of its own, so that what a hostile file does to a library happens there.
//
//     dapple-decode READER MOST-PIXELS over-paper|as-is ENOUGH-SIDE
//
// reads the file that is its descriptor 3, which is in the format of OpenImageIO's reader of that name, and
// writes it into standard output as image_pipe.h says.

#include <unistd.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/decoding/decode.h"
#include "app/decoding/decoder_limits.h"
#include "app/decoding/image_pipe.h"
#include "core/text/numbers.h"

int main(int argc, char** argv) {
    using namespace dapple;
    constexpr int kFile = 3, kUsage = 2;
    if (argc != 5) return kUsage;
    const auto format = format_with_reader(argv[1]);
    const auto most_pixels = number_of<long long>(argv[2]);
    const auto enough_side = number_of<int>(argv[4]);
    if (!format || !most_pixels || !enough_side) return kUsage;
    const DecodeRequest request{.over_paper = std::string_view(argv[3]) == "over-paper",
                                .most_pixels = *most_pixels,
                                .enough_side = *enough_side};
    limit_decoder();
    ImagePipe pipe(STDOUT_FILENO);
    try {
        try {
            decode(kFile, *format, request, &limit_decoder_to, pipe);
            pipe.finish();
        } catch (const TooManyPixels& error) {
            pipe.fail(error.what(), true);
        } catch (const DecodeError& error) {
            pipe.fail(error.what(), false);
        } catch (const std::bad_alloc&) {
            pipe.fail(kTooMuchMemory, false);
        } catch (const std::length_error&) {
            pipe.fail(kTooMuchMemory, false);
        } catch (const std::exception& error) {  // of a library
            pipe.fail(std::string("the picture is damaged (") + error.what() + ")", false);
        }
    } catch (const std::exception&) {
        // Whoever asked for the picture has gone.
    }
    // At once: hundreds of libraries would take their time to say goodbye.
    ::_exit(0);
}
