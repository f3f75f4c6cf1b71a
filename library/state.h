#pragma once
// What is behind the library's edge of more than one of its files.

#include "core/drawing/settings.h"
#include "dapple/settings.h"

namespace dapple {

struct Settings::State {
    DrawingSettings drawing;
    SavingChoice saving;
};

}  // namespace dapple
