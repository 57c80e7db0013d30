// Paints marks with OpenGL 3.3 core: window and PNG alike. One instanced draw call for all forms; labels are letters
// and belong to the label painter. Lives on the thread that holds the context.
#pragma once

#include <string_view>
#include <vector>

#include "app/paint/gl/handle.h"
#include "app/view/camera.h"
#include "app/view/marks.h"

namespace ghostforce {

// A rectangle of the framebuffer [px], origin at the lower left as OpenGL counts.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

class GlPainter {
 public:
  // Throws gl::ShaderError. Needs a current context.
  GlPainter();

  // Draws with other shaders from now on. Throws gl::ShaderError, and goes on with those in use.
  void use_shaders(std::string_view vertex_source, std::string_view fragment_source);

  void fill(Colour colour, const PixelRect& rect);

  // `pixels_per_point` is the framebuffer's density. Leaves blending and viewport changed.
  void paint(const Marks& marks, const Camera& camera, const PixelRect& rect, double pixels_per_point);

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

  gl::Program program_;
  gl::VertexArray attributes_;
  gl::Buffer instances_;
  GLint viewport_uniform_;
  std::vector<Instance> collected_;
};

}  // namespace ghostforce
