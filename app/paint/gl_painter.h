// Paints panes with OpenGL 3.3 core: window and PNG alike. Forms that follow each other are one instanced draw call,
// areas and rasters one each; the words stand above them in the screen's fonts. Needs an ImGui frame, and the thread
// that holds the context.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "app/paint/area_coverage.h"
#include "app/paint/handle.h"
#include "app/paint/label_painter.h"
#include "app/picture/marks.h"
#include "app/picture/panes.h"
#include "app/picture/theme.h"

namespace ghostforce {

// Draws what is no single outline: areas and rasters, each as a texture on a rectangle. Needs blending on.
class TexturePainter {
 public:
  // Throws gl::ShaderError. Needs a current context.
  TexturePainter();

  // On a viewport of that many pixels.
  void paint(const AreaCoverage& area, Colour fill, const Vector<2>& viewport) const;
  // `corner` and `size` in pixels from its upper left corner.
  void paint(const Raster& raster, const Vector<2>& corner, const Vector<2>& size, const Vector<2>& viewport) const;

 private:
  void draw(const Vector<2>& corner, const Vector<2>& size, Colour tint, bool holds_shares,
            const Vector<2>& viewport) const;

  gl::Program program_;
  gl::VertexArray no_attributes_;
  gl::Texture coverage_;  // one channel: how much of the tint there is
  gl::Texture cells_;     // smooth between the cells' middles
  GLint rectangle_uniform_;
  GLint viewport_uniform_;
  GLint tint_uniform_;
  GLint holds_shares_uniform_;
};

class GlPainter {
 public:
  // Throws gl::ShaderError. Needs a current context.
  explicit GlPainter(const LabelFonts& fonts);

  // Draws with other shaders from now on. Throws gl::ShaderError, and goes on with those in use.
  void use_shaders(std::string_view vertex_source, std::string_view fragment_source);

  // Clears the whole target of `pixel_width` × `pixel_height`, then paints. `corner` is the upper left of the panes'
  // rectangle on the screen, `text_scale` turns a nominal text height into points. Leaves blending and viewport
  // changed.
  void paint(const std::vector<Pane>& panes, const Theme& theme, ImVec2 corner, double text_scale, int pixel_width,
             int pixel_height);

  // The same without words, which go to a draw list by label_painter.h; `density`: pixels per point.
  void paint_without_words(const std::vector<Pane>& panes, const Theme& theme, ImVec2 corner, double density,
                           int pixel_width, int pixel_height);

  // A pane without its words, a pixel for each of its points, lowest row first. Leaves blending and viewport changed.
  gl::Texture texture_of(const Pane& pane, const Theme& theme);

 private:
  // Must match the inputs of shaders/mark.vert.
  struct Instance {
    float ends[4];
    float form[4];
    float pattern[4];
    Colour fill;
    Colour rim;
  };
  struct Collect;
  // A rectangle of the framebuffer [px], origin at the lower left as OpenGL counts.
  struct PixelRect {
    int x, y, width, height;
  };

  static void fill(Colour colour, std::span<const PixelRect> rects);
  void paint_marks(const Pane& pane, const PixelRect& rect, double pixels_per_point);
  // Those that are collected.
  void paint_instances(const PixelRect& rect);
  // One that nothing shines through.
  void paint_half_plane(const HalfPlane& form, const Collect& collect, const PixelRect& rect);

  LabelFonts fonts_;
  gl::Program program_;
  TexturePainter textures_;
  gl::VertexArray attributes_;
  gl::Buffer instances_;
  GLint viewport_uniform_;
  std::vector<Instance> collected_;
};

}  // namespace ghostforce
