#pragma once
// Drawings that the window no longer shows: their memory is used again, or given back to the system.

#include <cstddef>
#include <vector>

#include "app/viewer/background/placed_drawing.h"

namespace dapple {

/// One of them, or an empty one.
PlacedDrawing take_spare(std::vector<PlacedDrawing>& spare);

/// Keeps few, and none with far more room than drawings of so many dots need.
void keep_few(std::vector<PlacedDrawing>& spare, std::size_t dots);

/// Frees what a drawing has far more room for than it has dots.
void shrink_if_far_too_large(PlacedDrawing& drawing);

/// What was freed in small pieces stays with the C library otherwise.
void give_memory_back();

}  // namespace dapple
