#pragma once
#include "kiss_fft.h"
