#include "io/files/picture.h"

#include <fmt/format.h>

#include <stb_image.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/image/auto_tone.h"
#include "core/image/tone.h"
#include "core/maths/portable_math.h"
#include "core/text/shown_text.h"
#include "dapple_assets_embedded/assets.h"
#include "io/decoding/decoder_process.h"

namespace dapple {

Picture sample_picture(PictureColours colours) {
    return decode_png(assets::still_life_png(), colours);
}

namespace {

constexpr glm::vec3 kRec709{0.2126f, 0.7152f, 0.0722f};

int preview_side(int side, int longer) {
    if (longer <= kPreviewSide) return side;
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) * kPreviewSide / longer)));
}

int pixels_in_one(int width, int height, std::int64_t most) {
    const double pixels = static_cast<double>(width) * height;
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / static_cast<double>(most)))));
}

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

PictureBuilder::PictureBuilder(int width, int height, ExifOrientation orientation, PictureColours colours,
                               std::int64_t most_light)
    : pixels_in_one_(pixels_in_one(width, height, most_light)),
      rows_in_file_(height),
      stored_width_((width + pixels_in_one_ - 1) / pixels_in_one_),
      stored_height_((height + pixels_in_one_ - 1) / pixels_in_one_),
      orientation_(orientation) {
    width = stored_width_;
    height = stored_height_;
    if (orientation.swaps_sides()) std::swap(width, height);
    light_ = Grid<float>(width, height);
    if (colours == PictureColours::kept) colours_ = ColourGrid(width, height);
    const int longer = std::max(width, height);
    preview_ = Grid<Sum>(preview_side(width, longer), preview_side(height, longer));
}

void PictureBuilder::add_row(int y, std::span<const glm::vec3> colours) {
    if (pixels_in_one_ == 1) return keep_row(y, colours);
    sums_.resize(stored_width_);
    means_.resize(stored_width_);
    for (std::size_t x = 0; x < colours.size(); ++x) {
        Sum& sum = sums_[x / pixels_in_one_];
        sum.light += colours[x];
        sum.count += 1;
    }
    if ((y + 1) % pixels_in_one_ != 0 && y + 1 < rows_in_file_) return;
    std::ranges::transform(sums_, means_.begin(), [](const Sum& sum) { return sum.light / sum.count; });
    keep_row(y / pixels_in_one_, means_);
    sums_.clear();
}

void PictureBuilder::keep_row(int y, std::span<const glm::vec3> colours) {
    for (int x = 0; x < stored_width_; ++x) {
        const glm::vec3 colour = colours[x];
        const glm::ivec2 to = orientation_.upright(x, y, stored_width_, stored_height_);
        light_.at(to.x, to.y) = glm::dot(colour, kRec709);
        if (!colours_.empty()) colours_.at(to.x, to.y) = packed(colour);
        const auto scaled = [](int place, int from, int onto) {
            return static_cast<int>(static_cast<std::int64_t>(place) * onto / from);
        };
        Sum& sum = preview_.at(scaled(to.x, light_.width, preview_.width),
                               scaled(to.y, light_.height, preview_.height));
        sum.light += colour;
        sum.count += 1;
    }
}

Picture PictureBuilder::finish(std::string description, bool scene_light) {
    Picture picture;
    picture.pixels_in_one = pixels_in_one_;
    if (scene_light) picture.exposure = usual_exposure(light_);
    const float gain = portable::exp2(picture.exposure);
    picture.preview = Grid<glm::u8vec4>(preview_.width, preview_.height);
    for (std::size_t i = 0; i < preview_.values.size(); ++i) {
        const Sum& sum = preview_.values[i];
        const glm::vec3 mean = sum.light * (gain / std::max(sum.count, 1.0f));
        picture.preview.values[i] = glm::u8vec4(srgb_bytes(mean), 255);
    }
    picture.light = std::move(light_);
    picture.colours = std::move(colours_);
    picture.description = std::move(description);
    return picture;
}

Picture read_picture(const std::filesystem::path& path, PictureLimit limit, PictureColours colours,
                     std::stop_token stop, PictureBehind behind) {
    PictureSink sink(colours);
    const auto most = limit == PictureLimit::usual ? kUsualPixels : kAnyPixels;
    try {
        decode_file(path, {.over_paper = behind == PictureBehind::paper, .most_pixels = most}, sink, stop);
    } catch (const TooManyPixels& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what() + "; to read it, use --huge");
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

Picture decode_png(std::string_view bytes, PictureColours colours) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &width, &height, &channels, STBI_rgb_alpha),
        &stbi_image_free);
    if (!pixels) throw std::runtime_error("the picture in memory is not a PNG that can be read");

    std::array<float, 256> linear;
    for (int i = 0; i < 256; ++i) linear[i] = srgb_to_linear(static_cast<float>(i) / 255.0f);

    PictureBuilder builder(width, height, {}, colours);
    std::vector<glm::vec3> row(width);
    const stbi_uc* pixel = pixels.get();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, pixel += 4) {
            const float alpha = static_cast<float>(pixel[3]) / 255.0f;
            const glm::vec3 colour{linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]};
            row[x] = colour * alpha + (1.0f - alpha);
        }
        builder.add_row(y, row);
    }
    return builder.finish(fmt::format("{} x {} pixels, 8-bit png", width, height));
}

}  // namespace dapple
