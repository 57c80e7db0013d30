#include "app/paint/shaders.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "embedded_shaders.h"

namespace ghostforce {

std::string_view embedded_shader(std::string_view name) {
  const auto found = std::find_if(embedded_shaders.begin(), embedded_shaders.end(),
                                  [&](const auto& text) { return text.name == name; });
  if (found == embedded_shaders.end()) throw std::logic_error("no embedded shader " + std::string(name));
  return found->contents;
}

namespace gl {

namespace {

std::string numbered(std::string_view source) {
  std::string result;
  for (int number = 1; !source.empty(); ++number) {
    const std::size_t end = source.find('\n');
    result += fmt::format("{:4} {}\n", number, source.substr(0, end));
    source.remove_prefix(end == std::string_view::npos ? source.size() : end + 1);
  }
  return result;
}

// The source with the platform's prologue. A version of its own gives way to that; the driver counts lines as in the
// file.
std::string with_prologue(std::string_view source) {
  int first_line = 1;
  if (source.starts_with("#version")) {
    source.remove_prefix(std::min(source.size(), source.find('\n')));
    if (!source.empty()) source.remove_prefix(1);
    first_line = 2;
  }
  return fmt::format("{}#line {}\n{}", shader_prologue, first_line, source);
}

void compile(GLuint shader, std::string_view title, std::string_view source) {
  const std::string whole = with_prologue(source);
  const GLchar* text = whole.data();
  const auto length = static_cast<GLint>(whole.size());
  glShaderSource(shader, 1, &text, &length);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return;
  std::vector<char> log(4096, '\0');
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw ShaderError(fmt::format("the {} shader does not compile:\n{}\n{}", title, log.data(), numbered(source)));
}

}  // namespace

Program link_program(std::string_view vertex_source, std::string_view fragment_source) {
  const VertexShader vertex;
  const FragmentShader fragment;
  compile(vertex.name(), "vertex", vertex_source);
  compile(fragment.name(), "fragment", fragment_source);
  Program program;
  glAttachShader(program.name(), vertex.name());
  glAttachShader(program.name(), fragment.name());
  glLinkProgram(program.name());
  GLint good = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return program;
  std::vector<char> log(4096, '\0');
  glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw ShaderError(fmt::format("the shaders do not link:\n{}", log.data()));
}

}  // namespace gl

}  // namespace ghostforce
