#pragma once
// One small movable owner for each kind of OpenGL object. All need a current context, also to be destroyed.

#include <epoxy/gl.h>

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

/// Owns the name of an object; a moved-from one owns nothing.
template <void (*Delete)(GLuint)>
class GlName {
 public:
    GlName() = default;
    explicit GlName(GLuint name) : name_(name) {}
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (name_) Delete(name_);
    }
    GLuint get() const { return name_; }

 private:
    GLuint name_ = 0;
};

struct GlDelete {
    static void program(GLuint name) { glDeleteProgram(name); }
    static void buffer(GLuint name) { glDeleteBuffers(1, &name); }
    static void vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
    static void texture(GLuint name) { glDeleteTextures(1, &name); }
    static void framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
};

/// Compiled and linked shaders. Throws std::runtime_error with the driver's words if they are wrong.
class GlProgram {
 public:
    GlProgram(std::string_view vertex_source, std::string_view fragment_source);

    void use() const { glUseProgram(name_.get()); }
    GLint uniform(const char* name) const { return glGetUniformLocation(name_.get(), name); }

 private:
    GlName<GlDelete::program> name_;
};

class GlVertexArray {
 public:
    GlVertexArray();
    void bind() const { glBindVertexArray(name_.get()); }

 private:
    GlName<GlDelete::vertex_array> name_;
};

/// A vertex buffer that is written anew as a whole: the old storage is orphaned, so that writing never waits
/// for drawing.
class GlStreamBuffer {
 public:
    GlStreamBuffer();
    void bind() const { glBindBuffer(GL_ARRAY_BUFFER, name_.get()); }
    void write(std::span<const std::byte> bytes);
    /// Has the new storage filled, all of it.
    void write(std::size_t bytes, const std::function<void(std::byte* place)>& fill);

 private:
    GlName<GlDelete::buffer> name_;
    std::size_t capacity_ = 0;
};

/// An sRGB-encoded picture with mipmaps.
class GlTexture {
 public:
    GlTexture();
    void bind() const { glBindTexture(GL_TEXTURE_2D, name_.get()); }
    void write(const Grid<glm::u8vec4>& pixels);
    /// The same in slices: room for a picture and its mipmaps, each half as large, whose rows are then put
    /// one after the other. Before all of them are there, what it shows is anything.
    void make_room(int width, int height);
    void put_rows(int level, const Grid<glm::u8vec4>& pixels, int first, int count);
    GLuint get() const { return name_.get(); }

 private:
    GlName<GlDelete::texture> name_;
};

/// What a picture that is drawn into keeps of what a fragment shader says.
enum class Texels {
    as_given,  // four bytes
    shown,     // four bytes in the order of a window's, so that it takes a copy to show them
    light,     // linear light and alpha: four bytes that are sRGB-encoded, and mixed in linear light
    cover,     // red alone, in one byte; read, it stands in all four components
};

/// A picture to draw into, without depth; or several as large, one for each of a fragment shader's outputs.
class GlFramebuffer {
 public:
    GlFramebuffer();
    /// Leaves what is in it unset, unless it is as it was.
    void resize(glm::ivec2 size, Texels texels = Texels::as_given, std::size_t pictures = 1);
    glm::ivec2 size() const { return size_; }
    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, name_.get()); }
    void bind_to_read() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, name_.get()); }
    void bind_texture(std::size_t picture = 0) const { pictures_[picture].bind(); }
    GLuint texture() const { return pictures_[0].get(); }
    std::size_t pictures() const { return pictures_.size(); }

 private:
    GlName<GlDelete::framebuffer> name_;
    std::vector<GlTexture> pictures_{1};
    glm::ivec2 size_{0, 0};
    Texels texels_ = Texels::as_given;
};

}  // namespace dapple
