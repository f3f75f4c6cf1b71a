#include "app/viewer/background/spare_drawings.h"

#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace dapple {
namespace {

constexpr std::size_t kMostSpare = 2;
constexpr std::size_t kManyDots = 1'000'000;  // fewer are not worth giving their memory back

std::size_t room_of(const PlacedDrawing& drawing) {
    std::size_t room = 0;
    for (const Dots& piece : drawing.dots.pieces) room += piece.x.capacity();
    return room;
}

bool far_too_large(std::size_t room, std::size_t dots) {
    return room > kManyDots && room > 4 * dots;
}

}  // namespace

void give_memory_back() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

PlacedDrawing take_spare(std::vector<PlacedDrawing>& spare) {
    if (spare.empty()) return {};
    PlacedDrawing last = std::move(spare.back());
    spare.pop_back();
    return last;
}

void keep_few(std::vector<PlacedDrawing>& spare, std::size_t dots) {
    std::vector<PlacedDrawing> kept;
    std::size_t freed = 0;
    for (PlacedDrawing& drawing : spare) {
        const std::size_t room = room_of(drawing);
        if (kept.size() < kMostSpare && !far_too_large(room, dots))
            kept.push_back(std::move(drawing));
        else
            freed += room;
    }
    spare = std::move(kept);
    if (freed > kManyDots) give_memory_back();
}

void shrink_if_far_too_large(PlacedDrawing& drawing) {
    if (!far_too_large(room_of(drawing), drawing.dots.size())) return;
    for (Dots& piece : drawing.dots.pieces) {
        for (FloatBuffer* column : {&piece.x, &piece.y, &piece.threshold, &piece.critical, &piece.radius})
            column->shrink_to_fit();
    }
    drawing.colours.shrink_to_fit();
    give_memory_back();
}

}  // namespace dapple
