#pragma once

#include "assets/make/scene.h"

namespace dapple::make {

/// The sample picture's arrangement: plain solids on a table, lit from the upper left.
Scene still_life();

}  // namespace dapple::make
