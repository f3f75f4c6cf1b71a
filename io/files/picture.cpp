#include "io/files/picture.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "core/drawing/pipeline.h"
#include "core/text/shown_text.h"
#include "io/decoding/decoder_process.h"
#include "io/files/picture_builder.h"

namespace dapple {
namespace {

class PictureSink : public ImageSink {
 public:
    explicit PictureSink(PictureColours colours) : colours_(colours) {}
    void begin(const ImageHeader& header) override {
        builder_.emplace(header.width, header.height, ExifOrientation{header.orientation}, colours_);
        header_ = header;
    }
    void row(std::span<const glm::vec3> colours) override { builder_->add_row(row_++, colours); }
    Picture finish() {
        Picture picture = builder_->finish(std::move(header_.description), header_.scene_light);
        picture.remark = std::move(header_.remark);
        return picture;
    }

 private:
    PictureColours colours_;
    std::optional<PictureBuilder> builder_;
    ImageHeader header_;
    int row_ = 0;
};

}  // namespace

Picture read_picture(const std::filesystem::path& path, PictureLimit limit, PictureColours colours,
                     std::stop_token stop, PictureBehind behind) {
    PictureSink sink(colours);
    const auto most = limit == PictureLimit::usual ? kUsualPixels : kAnyPixels;
    try {
        decode_file(path, {.over_paper = behind == PictureBehind::paper, .most_pixels = most}, sink, stop);
    } catch (const TooManyPixels& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what() +
                                 "; --huge reads it all the same");
    } catch (const DecodeError& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what());
    }
    return sink.finish();
}

std::optional<Picture> read_first_look(const std::filesystem::path& path, PictureColours colours,
                                       std::stop_token stop) {
    PictureSink sink(colours);
    try {
        decode_file_smaller(path, {.enough_side = kFirstLookSide}, sink, stop);
    } catch (const DecodeError&) {
        return std::nullopt;
    }
    return sink.finish();
}

void set_picture(Pipeline& pipeline, Picture picture) {
    pipeline.set_light(std::move(picture.light), picture.exposure, picture.pixels_in_one);
    if (!picture.colours.empty()) pipeline.set_colours(std::move(picture.colours));
}

}  // namespace dapple
