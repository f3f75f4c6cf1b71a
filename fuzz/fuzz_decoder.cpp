// Feeds a decoder with files that are nearly right. What ends the decoder's process is contained by the
// program, and counted here. KIND is a format as reader_of() names it.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "app/decoding/decode.h"
#include "app/decoding/decoder_limits.h"
#include "fuzz/report.h"

using namespace dapple;

namespace {

class Forgetful : public ImageSink {
 public:
    void begin(const ImageHeader&) override {}
    void row(std::span<const glm::vec3>) override {}
};

void read(PictureFormat format, const std::string& bytes) {
    const int file = ::memfd_create("picture", 0);
    if (file < 0 || ::write(file, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        throw std::runtime_error("no memory for a file");
    ::lseek(file, 0, SEEK_SET);
    // Smaller pictures than people may have: hundreds of megapixels of nothing take their time.
    constexpr std::int64_t kMostPixels = 20'000'000;
    limit_decoder_memory(0);
    Forgetful sink;
    try {
        decode(file, format, {.most_pixels = kMostPixels}, &limit_decoder_memory, sink);
    } catch (const std::exception&) {
        // A sentence, as it should be.
    }
    ::close(file);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const FuzzOptions options = fuzz_options(argc, argv);
        const auto format = format_with_reader(options.kind);
        if (!format) throw std::runtime_error(options.kind + ": no format of that name");
        std::freopen("/dev/null", "w", stderr);  // libraries say there what they find wrong
        fuzz(options, [&](const std::string& file) { read(*format, file); });
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
