#pragma once
// Calls of libpng, whose way to report an error is to jump out of them.

#include <png.h>

#include <csetjmp>
#include <string>

namespace dapple {

/// What libpng finds wrong is kept here instead of printed.
struct PngComplaint {
    std::string message;

    static void fail(png_structp png, png_const_charp message) {
        static_cast<PngComplaint*>(png_get_error_ptr(png))->message = message ? message : "";
        png_longjmp(png, 1);
    }
    static void ignore(png_structp, png_const_charp) {}
};

/// Makes calls of libpng. False if it jumped out of one: nothing in `calls` may need to be destroyed then.
template <class Calls>
bool png_calls(png_structp png, const Calls& calls) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    calls();
    return true;
}

}  // namespace dapple
