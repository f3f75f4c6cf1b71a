#pragma once
// Marks what the shared library shows of core to other programs.

#ifndef DAPPLE_API
#if defined(__GNUC__)
#define DAPPLE_API __attribute__((visibility("default")))
#else
#define DAPPLE_API
#endif
#endif
