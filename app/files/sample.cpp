#include "app/files/sample.h"

#include "dapple_assets_embedded/assets.h"

namespace dapple {

Picture sample_picture() {
    return decode_png(assets::still_life_png());
}

}  // namespace dapple
