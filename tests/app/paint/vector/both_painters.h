// The same panes as both painters draw them: OpenGL and Cairo. For tests.
#pragma once

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

#include "app/files/image.h"
#include "app/paint/gl_painter.h"
#include "app/paint/vector/vector_painter.h"
#include "app/shell/desktop/glfw_window.h"
#include "tests/app/paint/vector/vector_panes.h"

namespace ghostforce {

inline Image drawn_by_cairo(const std::vector<Pane>& panes, const Theme& theme) {
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  cairo_t* target = cairo_create(surface);
  paint_panes(panes, theme, size, theme.thickness, target);
  EXPECT_EQ(cairo_status(target), CAIRO_STATUS_SUCCESS);
  cairo_surface_flush(surface);
  Image image{width, height, {}};
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const unsigned char* pixel = cairo_image_surface_get_data(surface) + y * stride + 4 * x;  // blue, green, red
      for (const int channel : {2, 1, 0}) image.rgb.push_back(pixel[channel]);
    }
  }
  cairo_destroy(target);
  cairo_surface_destroy(surface);
  return image;
}

// One window for all of a test's pictures.
class OpenGl {
 public:
  Image draw(const std::vector<Pane>& panes, const Theme& theme) {
    window_.frame(0.0, [&] { painter_.paint(panes, theme, {0.0F, 0.0F}, theme.thickness, width, height); });
    return window_.picture();
  }
  Window& window() { return window_; }

 private:
  GlfwWindow window_{{.title = "test", .width = width, .height = height, .offscreen = true, .takes_mouse = false}};
  GlPainter painter_{window_.fonts()};
};

inline int difference(const Image& a, const Image& b, std::size_t pixel) {
  int greatest = 0;
  for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
    greatest = std::max(greatest, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
  }
  return greatest;
}

// How many pixels differ by more than a quarter of white in some channel: more than two ways to smooth an edge do.
inline int unlike_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.rgb.size() / 3; ++pixel) count += difference(a, b, pixel) > 64 ? 1 : 0;
  return count;
}

inline Pane pane_with(Marks marks) {
  return {Vector<2>(0.0), camera_on(Vector<2>(0.0), 0.09, size), StrategyId::full, std::move(marks)};
}

}  // namespace ghostforce
