#include "io/files/sample.h"

#include "dapple_assets_embedded/assets.h"

namespace dapple {

Picture sample_picture(PictureColours colours) {
    return decode_png(assets::still_life_png(), colours);
}

}  // namespace dapple
