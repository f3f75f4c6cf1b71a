#pragma once
// The small pictures of a list's entries, as textures.

#include <cstddef>
#include <map>
#include <string>

#include "app/viewer/background/small_pictures.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/widgets/picture_entry.h"

namespace dapple {

class EntryPictures {
 public:
    explicit EntryPictures(std::function<void()> wake) : pictures_(std::move(wake)) {}

    /// As SmallPictures::of(); bare while there is none.
    EntryPicture of(const std::string& key, const SmallPictures::Make& make);

    std::size_t size() const { return textures_.size(); }
    /// Gives up what is being made, and all memory. Only before the frame shows any of them.
    void forget();

 private:
    SmallPictures pictures_;
    std::map<std::string, GlTexture> textures_;
};

}  // namespace dapple
