#include "app/viewer/canvas/gl_objects.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

namespace dapple {
namespace {

template <class Generate>
GLuint generated(Generate generate) {
    GLuint name = 0;
    generate(1, &name);
    return name;
}

GLuint compile(GLenum stage, std::string_view source) {
    GLuint shader = glCreateShader(stage);
    const char* text = source.data();
    auto length = static_cast<GLint>(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    std::string log(2000, '\0');
    GLsizei used = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &used, log.data());
    log.resize(used);
    glDeleteShader(shader);
    throw std::runtime_error("The graphics driver refuses a shader: " + log);
}

}  // namespace

GlProgram::GlProgram(std::string_view vertex_source, std::string_view fragment_source)
    : name_(glCreateProgram()) {
    GLuint vertex = compile(GL_VERTEX_SHADER, vertex_source);
    GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
    glAttachShader(name_.get(), vertex);
    glAttachShader(name_.get(), fragment);
    glLinkProgram(name_.get());
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint linked = 0;
    glGetProgramiv(name_.get(), GL_LINK_STATUS, &linked);
    if (!linked) throw std::runtime_error("The graphics driver refuses to link a shader.");
}

GlVertexArray::GlVertexArray() : name_(generated([](GLsizei n, GLuint* p) { glGenVertexArrays(n, p); })) {}

GlStreamBuffer::GlStreamBuffer() : name_(generated([](GLsizei n, GLuint* p) { glGenBuffers(n, p); })) {}

void GlStreamBuffer::write(std::span<const std::byte> bytes) {
    write(bytes.size(), [bytes](std::byte* place) { std::memcpy(place, bytes.data(), bytes.size()); });
}

void GlStreamBuffer::write(std::size_t bytes, const std::function<void(std::byte* place)>& fill) {
    bind();
    if (bytes > capacity_) capacity_ = bytes + bytes / 4;
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
    if (bytes == 0) return;
    void* place = glMapBufferRange(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes),
                                   GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (!place) throw std::runtime_error("The graphics memory is too small for this many dots.");
    fill(static_cast<std::byte*>(place));
    glUnmapBuffer(GL_ARRAY_BUFFER);
}

GlTexture::GlTexture() : name_(generated([](GLsizei n, GLuint* p) { glGenTextures(n, p); })) {
    bind();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void GlTexture::write(const Grid<glm::u8vec4>& pixels) {
    bind();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.values.data());
    glGenerateMipmap(GL_TEXTURE_2D);
}

void GlTexture::make_room(int width, int height) {
    bind();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    for (int level = 0;; ++level, width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        if (width == 1 && height == 1) return;
    }
}

void GlTexture::put_rows(int level, const Grid<glm::u8vec4>& pixels, int first, int count) {
    bind();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, level, 0, first, pixels.width, count, GL_RGBA, GL_UNSIGNED_BYTE,
                    pixels.row(first));
}

GlFramebuffer::GlFramebuffer() : name_(generated([](GLsizei n, GLuint* p) { glGenFramebuffers(n, p); })) {}

void GlFramebuffer::resize(glm::ivec2 size, Texels texels, std::size_t pictures) {
    if (size == size_ && texels == texels_ && pictures == pictures_.size()) return;
    size_ = size;
    texels_ = texels;
    bind();
    // What is taken away has to be let go of first.
    for (std::size_t i = pictures; i < pictures_.size(); ++i)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + GLenum(i), GL_TEXTURE_2D, 0, 0);
    pictures_.resize(pictures);
    // Without a size OpenGL may choose the order of the bytes, and goes by the one that is handed over.
    const GLint format = texels == Texels::as_given ? GL_RGBA8
                         : texels == Texels::shown  ? GL_RGBA
                         : texels == Texels::light  ? GL_SRGB8_ALPHA8
                                                    : GL_R8;
    const GLenum given = texels == Texels::shown ? GL_BGRA : GL_RGBA;
    const std::array<GLint, 4> as_it_is{GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
    const std::array<GLint, 4> all_red{GL_RED, GL_RED, GL_RED, GL_RED};
    std::vector<GLenum> outputs;
    for (const GlTexture& picture : pictures_) {
        picture.bind();
        glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA,
                         (texels == Texels::cover ? all_red : as_it_is).data());
        glTexImage2D(GL_TEXTURE_2D, 0, format, size.x, size.y, 0, given, GL_UNSIGNED_BYTE, nullptr);
        outputs.push_back(GL_COLOR_ATTACHMENT0 + GLenum(outputs.size()));
        glFramebufferTexture2D(GL_FRAMEBUFFER, outputs.back(), GL_TEXTURE_2D, picture.get(), 0);
    }
    glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("The graphics driver cannot make a picture of " + std::to_string(size.x) +
                                 " x " + std::to_string(size.y) + " pixels to draw into.");
}

}  // namespace dapple
