#pragma once
#include "tests/threads/tbb/stand_in.h"
