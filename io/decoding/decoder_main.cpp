// A decoder: a program of its own, so that what a hostile file does to a library happens there.
//
//     dapple-decode READER MOST-PIXELS paper|black square|as-is ENOUGH-SIDE
//
// reads the file that is its descriptor kPictureFile, which is in the format of OpenImageIO's reader of that
// name, and writes it into standard output as image_pipe.h says.

#include <unistd.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/text/number_words.h"
#include "io/decoding/decoded_image.h"
#include "io/decoding/decoder_limits.h"
#include "io/decoding/decoder_sandbox.h"
#include "io/decoding/image_pipe.h"
#include "io/decoding/stored_pixels.h"

int main(int argc, char** argv) {
    using namespace dapple;
    constexpr int kUsage = 2;
    if (argc != 6) return kUsage;
    const auto format = format_with_reader(argv[1]);
    const auto most_pixels = number_of<long long>(argv[2]);
    const auto enough_side = number_of<int>(argv[5]);
    if (!format || !most_pixels || !enough_side) return kUsage;
    const DecodeRequest request{.over_paper = std::string_view(argv[3]) == "paper",
                                .square_pixels = std::string_view(argv[4]) == "square",
                                .most_pixels = *most_pixels,
                                .enough_side = *enough_side};
    end_with_parent(STDOUT_FILENO);
    limit_decoder(request.most_pixels);
    ImagePipe pipe(STDOUT_FILENO);
    const auto before_pixels = [&pipe](const PixelBytes& pixels) {
        limit_decoder_to(pixels);
        pipe.expect(pixels.in_all);
    };
    ImageSink& as_is = pipe;
    try {
        try {
            enter_sandbox();
            SquarePixels square(pipe);
            WindowSink window(request.square_pixels ? square : as_is, request.over_paper);
            decode(kPictureFile, *format, request, before_pixels, window);
            pipe.finish();
        } catch (const NoSandbox& error) {
            pipe.fail(error.what(), PictureFailure::system);
        } catch (const TooManyPixels& error) {
            pipe.fail(error.what(), PictureFailure::too_many_pixels);
        } catch (const DecodeError& error) {
            pipe.fail(error.what(), PictureFailure::file);
        } catch (const std::bad_alloc&) {
            pipe.fail(kTooMuchMemory, PictureFailure::file);
        } catch (const std::length_error&) {
            pipe.fail(kTooMuchMemory, PictureFailure::file);
        } catch (const std::exception& error) {  // of a library
            pipe.fail(std::string("the picture is damaged (") + error.what() + ")", PictureFailure::file);
        }
    } catch (const std::exception&) {
        // Whoever asked for the picture has gone.
    }
    // At once: hundreds of libraries would take their time to say goodbye.
    ::_exit(0);
}
