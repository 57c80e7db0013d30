// Move-only owners of OpenGL objects. Made, used and destroyed on the thread that holds the context.
#pragma once

#include <utility>

#include "opengl.h"

namespace ghostforce::gl {

template <GLuint (*make)(), void (*destroy)(GLuint)>
class Handle {
 public:
  Handle() : name_(make()) {}
  ~Handle() {
    if (name_ != 0) destroy(name_);
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

// `generate` and `remove` point to functions of the glGen… and glDelete… kind, or to pointers to such: a loader's.
template <auto* generate>
GLuint generated() {
  GLuint name = 0;
  (*generate)(1, &name);
  return name;
}
template <auto* remove>
void removed(GLuint name) {
  (*remove)(1, &name);
}
template <GLenum kind>
GLuint created_shader() {
  return glCreateShader(kind);
}
inline GLuint created_program() {
  return glCreateProgram();
}
inline void delete_shader(GLuint name) {
  glDeleteShader(name);
}
inline void delete_program(GLuint name) {
  glDeleteProgram(name);
}

using Buffer = Handle<generated<&glGenBuffers>, removed<&glDeleteBuffers>>;
using VertexArray = Handle<generated<&glGenVertexArrays>, removed<&glDeleteVertexArrays>>;
using Framebuffer = Handle<generated<&glGenFramebuffers>, removed<&glDeleteFramebuffers>>;
using Renderbuffer = Handle<generated<&glGenRenderbuffers>, removed<&glDeleteRenderbuffers>>;
using Texture = Handle<generated<&glGenTextures>, removed<&glDeleteTextures>>;
using Program = Handle<created_program, delete_program>;
using VertexShader = Handle<created_shader<GL_VERTEX_SHADER>, delete_shader>;
using FragmentShader = Handle<created_shader<GL_FRAGMENT_SHADER>, delete_shader>;

}  // namespace ghostforce::gl
