#include "app/viewer/background/small_pictures.h"

#include <exception>
#include <utility>

namespace dapple {

void SmallPictures::take_made() {
    try {
        while (auto made = making_.result())
            made_.insert_or_assign(std::move(made->key), std::move(made->picture));
    } catch (const std::exception&) {
        made_.insert_or_assign(under_way_, SmallPicture{});  // not again in each frame
    }
}

const SmallPicture* SmallPictures::of(const std::string& key, const Make& make) {
    take_made();
    if (const auto found = made_.find(key); found != made_.end()) return &found->second;
    if (making_.busy()) return nullptr;
    under_way_ = key;
    making_.begin([key, make](const Background<Made>::Task& task) -> std::optional<Made> {
        SmallPicture picture;
        try {
            picture = make(task.stop());
        } catch (const std::exception&) {
            // Whoever opens the entry is told what is wrong with it.
        }
        if (task.stop().stop_requested()) return std::nullopt;
        return Made{key, std::move(picture)};
    });
    return nullptr;
}

void SmallPictures::forget() {
    making_.stop();
    take_made();
    made_.clear();
}

}  // namespace dapple
