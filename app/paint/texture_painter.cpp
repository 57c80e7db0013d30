#include "app/paint/texture_painter.h"

#include "app/paint/embedded_shader.h"
#include "app/paint/shader_program.h"

namespace ghostforce {
namespace {

void choose_texture(const gl::Texture& texture, GLint filter) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

TexturePainter::TexturePainter()
    : program_(gl::link_program(embedded_shader("texture.vert"), embedded_shader("texture.frag"))),
      rectangle_uniform_(glGetUniformLocation(program_.name(), "rectangle")),
      viewport_uniform_(glGetUniformLocation(program_.name(), "viewport")),
      tint_uniform_(glGetUniformLocation(program_.name(), "tint")),
      holds_shares_uniform_(glGetUniformLocation(program_.name(), "holds_shares")) {
  choose_texture(coverage_, GL_NEAREST);
  choose_texture(cells_, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void TexturePainter::paint(const AreaCoverage& area, Colour fill, const Vector<2>& viewport) const {
  if (area.shares.empty()) return;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, coverage_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, area.width, area.height, 0, GL_RED, GL_UNSIGNED_BYTE, area.shares.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);  // as it is from the beginning
  draw({area.left, area.top}, {area.width, area.height}, fill, true, viewport);
}

void TexturePainter::paint(const Raster& raster, const Vector<2>& corner, const Vector<2>& size,
                           const Vector<2>& viewport) const {
  if (raster.cells.empty()) return;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, cells_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, raster.columns, raster.rows, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               raster.cells.data());
  draw(corner, size, rgb(0xFFFFFF), false, viewport);
}

void TexturePainter::draw(const Vector<2>& corner, const Vector<2>& size, Colour tint, bool holds_shares,
                          const Vector<2>& viewport) const {
  const auto single = [](double number) { return static_cast<float>(number); };
  const auto share = [](std::uint8_t channel) { return static_cast<float>(channel) / 255.0F; };
  const Vector<2> end = corner + size;
  glUseProgram(program_.name());
  glUniform4f(rectangle_uniform_, single(corner.x), single(corner.y), single(end.x), single(end.y));
  glUniform2f(viewport_uniform_, single(viewport.x), single(viewport.y));
  glUniform4f(tint_uniform_, share(tint.red), share(tint.green), share(tint.blue), share(tint.alpha));
  glUniform1i(holds_shares_uniform_, holds_shares ? 1 : 0);
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace ghostforce
