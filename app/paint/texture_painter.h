// Draws what is no single outline with OpenGL: areas and rasters, each as a texture on a rectangle. Needs blending on,
// and the thread that holds the context.
#pragma once

#include "app/paint/area_coverage.h"
#include "app/paint/handle.h"
#include "app/picture/marks.h"

namespace ghostforce {

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

}  // namespace ghostforce
