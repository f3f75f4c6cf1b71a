#include "app/viewer/canvas/entry_pictures.h"

#include "app/viewer/widgets/keys.h"

namespace dapple {

EntryPicture EntryPictures::of(const std::string& key, const SmallPictures::Make& make) {
    const SmallPicture* const picture = pictures_.of(key, make);
    if (!picture) return {.awaited = true};
    if (picture->empty()) return {};
    auto texture = textures_.find(key);
    if (texture == textures_.end()) {
        texture = textures_.emplace(key, GlTexture()).first;
        texture->second.write(*picture);
    }
    return {texture_id(texture->second.get()),
            {static_cast<float>(picture->width), static_cast<float>(picture->height)}};
}

void EntryPictures::forget() {
    pictures_.forget();
    textures_.clear();
}

}  // namespace dapple
