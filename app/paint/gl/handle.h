// Move-only owners of OpenGL objects. Made, used and destroyed on the thread that holds the context.
#pragma once

#include <glad/gl.h>

#include <utility>

namespace ghostforce::gl {

template <typename Traits>
class Handle {
 public:
  Handle() : name_(Traits::make()) {}
  ~Handle() {
    if (name_ != 0) Traits::destroy(name_);
  }
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint name() const noexcept { return name_; }

 private:
  GLuint name_;
};

struct BufferTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct FramebufferTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct RenderbufferTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct ProgramTraits {
  static GLuint make() { return glCreateProgram(); }
  static void destroy(GLuint name) { glDeleteProgram(name); }
};
struct VertexShaderTraits {
  static GLuint make() { return glCreateShader(GL_VERTEX_SHADER); }
  static void destroy(GLuint name) { glDeleteShader(name); }
};
struct FragmentShaderTraits {
  static GLuint make() { return glCreateShader(GL_FRAGMENT_SHADER); }
  static void destroy(GLuint name) { glDeleteShader(name); }
};

using Buffer = Handle<BufferTraits>;
using VertexArray = Handle<VertexArrayTraits>;
using Framebuffer = Handle<FramebufferTraits>;
using Renderbuffer = Handle<RenderbufferTraits>;
using Program = Handle<ProgramTraits>;
using VertexShader = Handle<VertexShaderTraits>;
using FragmentShader = Handle<FragmentShaderTraits>;

}  // namespace ghostforce::gl
