#include "app/paint/gl_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "app/paint/shaders.h"

namespace ghostforce {
namespace {

// Must match the constants of shaders/mark.frag.
constexpr float line_kind = 0.0F;
constexpr float disc_kind = 1.0F;
constexpr float diamond_kind = 2.0F;
constexpr float triangle_kind = 3.0F;
constexpr float arrow_kind = 4.0F;
constexpr float half_plane_kind = 5.0F;
constexpr float box_kind = 6.0F;

float kind_of(Shape shape) {
  switch (shape) {
    case Shape::disc:
      return disc_kind;
    case Shape::diamond:
      return diamond_kind;
    case Shape::triangle:
      return triangle_kind;
  }
  return disc_kind;
}

// What is hollow takes the rim's colour for its edge, else another would shine through there.
Colour fill_within(Colour fill, Colour rim) {
  return fill.alpha == 0 ? rim.with_alpha(0) : fill;
}

}  // namespace

// Turns each form into one instance, in pixels.
struct GlPainter::Collect {
  std::vector<Instance>& out;
  const Camera& camera;
  double density;
  PixelTile everything;  // of the viewport

  Vector<2> pixels(const Vector<2>& world, const Vector<2>& offset = Vector<2>(0.0)) const {
    return (to_screen(camera, world) + offset) * density;
  }
  float pixels(double points) const { return static_cast<float>(points * density); }
  void add(const Vector<2>& from, const Vector<2>& to, float kind, double radius, double rim_width, double start,
           const LinePattern& pattern, Colour fill, Colour rim) const {
    out.push_back(
        {{static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(to.x), static_cast<float>(to.y)},
         {kind, pixels(radius), pixels(rim_width), static_cast<float>(start)},
         {pixels(pattern[0]), pixels(pattern[1]), pixels(pattern[2]), pixels(pattern[3])},
         fill,
         rim});
  }

  void add_part(const HalfPlane& form, const PixelTile& part) const {
    const Vector<2> normal = to_screen_direction(form.normal);
    add(pixels(form.point), normal, half_plane_kind, 0.0, 0.0, 0.0, {}, form.fill, form.fill);
    const std::array values{part.left, part.top, part.width, part.height};
    std::ranges::transform(values, out.back().pattern, [](int pixels) { return static_cast<float>(pixels); });
  }
  void operator()(const HalfPlane& form) const { add_part(form, everything); }
  void operator()(const Line& form) const {
    add(pixels(form.from), pixels(form.to), line_kind, 0.5 * form.width, 0.0,
        form.pattern_start * camera.points_per_metre * density, form.pattern, form.colour, form.colour);
  }
  void operator()(const Marker& form) const {
    const Vector<2> center = pixels(form.center, form.offset);
    add(center, center, kind_of(form.shape), form.radius, form.rim_width, 0.0, solid_line, form.fill, form.rim);
  }
  void operator()(const Arrow& form) const {
    const double step = form.is_hatched ? stripe_step * form.width : 0.0;
    add(pixels(form.tail, form.offset), pixels(form.tip, form.offset), arrow_kind, 0.5 * form.width, form.rim_width,
        0.0, {form.has_head ? 0.0 : 1.0, step}, fill_within(form.fill, form.rim), form.rim);
  }
  void operator()(const Box& form) const {
    add(pixels(form.corner, form.offset), pixels(form.corner, form.offset + form.size), box_kind, form.radius,
        form.rim_width, 0.0, {0.5 * form.size.x, 0.5 * form.size.y}, fill_within(form.fill, form.rim), form.rim);
  }
  void operator()(const Area&) const {}    // see paint_marks()
  void operator()(const Raster&) const {}  // see paint_marks()
  void operator()(const Label&) const {}   // see paint()
};

GlPainter::GlPainter(const LabelFonts& fonts)
    : fonts_(fonts), program_(gl::link_program(embedded_shader("mark.vert"), embedded_shader("mark.frag"))) {
  viewport_uniform_ = glGetUniformLocation(program_.name(), "viewport");
  glBindVertexArray(attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  const auto attribute = [](GLuint index, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 4, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE, sizeof(Instance),
                          reinterpret_cast<const void*>(offset));  // an offset, in the shape that OpenGL wants it
    glVertexAttribDivisor(index, 1);
  };
  attribute(0, GL_FLOAT, offsetof(Instance, ends));
  attribute(1, GL_FLOAT, offsetof(Instance, form));
  attribute(2, GL_FLOAT, offsetof(Instance, pattern));
  attribute(3, GL_UNSIGNED_BYTE, offsetof(Instance, fill));
  attribute(4, GL_UNSIGNED_BYTE, offsetof(Instance, rim));
  glBindVertexArray(0);
}

void GlPainter::use_shaders(std::string_view vertex_source, std::string_view fragment_source) {
  gl::Program program = gl::link_program(vertex_source, fragment_source);
  viewport_uniform_ = glGetUniformLocation(program.name(), "viewport");
  program_ = std::move(program);
}

void GlPainter::fill(Colour colour, std::span<const PixelRect> rects) {
  const auto share = [](std::uint8_t channel) { return static_cast<float>(channel) / 255.0F; };
  glEnable(GL_SCISSOR_TEST);
  glClearColor(share(colour.red), share(colour.green), share(colour.blue), 1.0F);
  for (const PixelRect& rect : rects) {
    glScissor(rect.x, rect.y, rect.width, rect.height);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glDisable(GL_SCISSOR_TEST);
}

void GlPainter::paint_marks(const Pane& pane, const PixelRect& rect, double pixels_per_point) {
  if (rect.width <= 0 || rect.height <= 0) return;
  glViewport(rect.x, rect.y, rect.width, rect.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(rect.x, rect.y, rect.width, rect.height);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  const Vector<2> viewport{rect.width, rect.height};
  const Collect collect{collected_, pane.camera, pixels_per_point, {0, 0, rect.width, rect.height}};
  for (const Mark& mark : pane.marks) {
    if (const auto* area = std::get_if<Area>(&mark.form)) {
      paint_instances(rect);
      std::vector<Vector<2>> corners;
      for (const Vector<2>& corner : area->corners) corners.push_back(collect.pixels(corner));
      textures_.paint(area_coverage(corners, rect.width, rect.height), area->fill, viewport);
    } else if (const auto* raster = std::get_if<Raster>(&mark.form)) {
      paint_instances(rect);
      textures_.paint(*raster, collect.pixels(raster->corner), raster->size * pixels_per_point, viewport);
    } else if (const auto* half_plane = std::get_if<HalfPlane>(&mark.form);
               half_plane != nullptr && half_plane->fill.alpha == 255) {
      paint_instances(rect);
      paint_half_plane(*half_plane, collect, rect);
    } else {
      std::visit(collect, mark.form);
    }
  }
  paint_instances(rect);
  glDisable(GL_SCISSOR_TEST);
}

void GlPainter::paint_half_plane(const HalfPlane& form, const Collect& collect, const PixelRect& rect) {
  const HalfPlaneTiles tiles =
      half_plane_tiles(collect.pixels(form.point), to_screen_direction(form.normal), rect.width, rect.height);
  const auto in_framebuffer = [&rect](const PixelTile& tile) {
    return PixelRect{rect.x + tile.left, rect.y + rect.height - tile.top - tile.height, tile.width, tile.height};
  };
  std::vector<PixelRect> whole;
  for (const PixelTile& tile : tiles.whole) whole.push_back(in_framebuffer(tile));
  fill(form.fill, whole);
  glEnable(GL_SCISSOR_TEST);
  glScissor(rect.x, rect.y, rect.width, rect.height);
  for (const PixelTile& tile : tiles.edge) collect.add_part(form, tile);
}

void GlPainter::paint_instances(const PixelRect& rect) {
  if (collected_.empty()) return;
  glUseProgram(program_.name());
  glUniform2f(viewport_uniform_, static_cast<float>(rect.width), static_cast<float>(rect.height));
  glBindVertexArray(attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(collected_.size() * sizeof(Instance)), collected_.data(),
               GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(collected_.size()));
  glBindVertexArray(0);
  collected_.clear();
}

void GlPainter::paint(const std::vector<Pane>& panes, const Theme& theme, ImVec2 corner, double text_scale,
                      int pixel_width, int pixel_height) {
  const double density = static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
  paint_without_words(panes, theme, corner, density, pixel_width, pixel_height);
  for (const Pane& pane : panes) {
    const ImVec2 at{corner.x + static_cast<float>(pane.corner.x), corner.y + static_cast<float>(pane.corner.y)};
    paint_labels(pane.marks, pane.camera, fonts_, at, text_scale, *ImGui::GetBackgroundDrawList());
  }
}

void GlPainter::paint_without_words(const std::vector<Pane>& panes, const Theme& theme, ImVec2 corner, double density,
                                    int pixel_width, int pixel_height) {
  const bool has_gaps = panes.size() > 1;
  // Between panes the target shows through.
  const PixelRect target{0, 0, pixel_width, pixel_height};
  fill(has_gaps ? theme.panel_border : theme.background, {&target, 1});
  const auto pixels = [density](double points) { return static_cast<int>(std::lround(points * density)); };
  for (const Pane& pane : panes) {
    const Vector<2> at = Vector<2>(static_cast<double>(corner.x), static_cast<double>(corner.y)) + pane.corner;
    const int left = pixels(at.x);
    const int top = pixels(at.y);
    const int right = pixels(at.x + pane.camera.size.x);
    const int bottom = pixels(at.y + pane.camera.size.y);
    const PixelRect rect{left, pixel_height - bottom, right - left, bottom - top};
    if (has_gaps) fill(theme.background, {&rect, 1});
    paint_marks(pane, rect, density);
  }
}

gl::Texture GlPainter::texture_of(const Pane& pane, const Theme& theme) {
  const PixelRect rect{0, 0, static_cast<int>(std::lround(pane.camera.size.x)),
                       static_cast<int>(std::lround(pane.camera.size.y))};
  gl::Texture texture;
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, rect.width, rect.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  GLint before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  const gl::Framebuffer framebuffer;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
  fill(theme.background, {&rect, 1});
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);  // opaque it stays: blending would leave less than that in it
  paint_marks(pane, rect, 1.0);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
  return texture;
}

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
