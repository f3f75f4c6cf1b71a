#include "tests/picture_files.h"

#include <OpenImageIO/imageio.h>

#include <memory>
#include <stdexcept>

namespace dapple {

void write_picture(const std::filesystem::path& path, const PictureFile& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeDesc(picture.type));
    if (!picture.colour_space.empty()) spec.attribute("oiio:ColorSpace", picture.colour_space);
    if (!picture.profile.empty()) {
        const OIIO::TypeDesc bytes(OIIO::TypeDesc::UINT8, static_cast<int>(picture.profile.size()));
        spec.attribute("ICCProfile", bytes, picture.profile.data());
    }
    if (picture.orientation != 1) spec.attribute("Orientation", picture.orientation);
    if (picture.channels == 2 || picture.channels == 4) {
        spec.alpha_channel = picture.channels - 1;
        // Integer formats get colours that are not multiplied by alpha, unless they are; EXR ones that are.
        if (path.extension() != ".exr" && !picture.premultiplied) spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    if (picture.channels == 2) spec.channelnames = {"Y", "A"};
    if (picture.strip > 0) spec.attribute("tiff:RowsPerStrip", picture.strip);
    if (picture.planes) spec.attribute("planarconfig", "separate");
    if (picture.tile > 0) spec.tile_width = spec.tile_height = picture.tile;

    const std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create(path.string());
    const auto mode = picture.append ? OIIO::ImageOutput::AppendSubimage : OIIO::ImageOutput::Create;
    if (!file || !file->open(path.string(), spec, mode) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, picture.values.data()) || !file->close()) {
        throw std::runtime_error("test picture " + path.string() + ": " +
                                 (file ? file->geterror() : OIIO::geterror()));
    }
}

}  // namespace dapple
