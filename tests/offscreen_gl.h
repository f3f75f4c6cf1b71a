#pragma once
// OpenGL 3.3 without a window or a display: EGL's surfaceless platform and a framebuffer.

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <stdexcept>

#include "app/viewer/canvas/gl_objects.h"
#include "core/image/grid.h"

namespace dapple {

class OffscreenContext {
 public:
    OffscreenContext() {
        display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (!eglInitialize(display_, nullptr, nullptr)) throw std::runtime_error("no EGL without a display");
        eglBindAPI(EGL_OPENGL_API);
        const EGLint want[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglChooseConfig(display_, want, &config, 1, &count);
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
        if (!context_ || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw std::runtime_error("no OpenGL 3.3 without a display");
    }
    ~OffscreenContext() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
    EGLDisplay display_ = nullptr;
    EGLContext context_ = nullptr;
};

/// The bound framebuffer's pixels, in its order.
inline Grid<glm::u8vec4> read_pixels(glm::ivec2 size) {
    Grid<glm::u8vec4> pixels(size.x, size.y);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.values.data());
    return pixels;
}

}  // namespace dapple
