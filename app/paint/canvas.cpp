#include "app/paint/canvas.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "app/base/failure.h"

namespace ghostforce::gl {
namespace {

void refuse_larger_than_driver_draws(int width, int height) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (std::max(width, height) <= largest) return;
  throw Failure(ExitCode::wrong_call, fmt::format("the graphics driver draws pictures of {} pixels at most each way; "
                                                  "choose a smaller one",
                                                  largest));
}

}  // namespace

Canvas::Canvas(int width, int height) : width_(width), height_(height) {
  refuse_larger_than_driver_draws(width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, colours_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_.name());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Failure(ExitCode::wrong_call,
                  "the graphics driver has no room for a picture of this size; choose a smaller one");
  }
  glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  glClear(GL_COLOR_BUFFER_BIT);
}

Image pixels_drawn(int width, int height) {
  // With alpha: without it, a browser's OpenGL reads nothing.
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  std::vector<unsigned char> rgba(row * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Image image{width, height, {}};
  image.rgb.resize(rgba.size() / 4 * 3);
  std::size_t written = 0;
  // OpenGL counts rows from below.
  for (auto y = static_cast<std::size_t>(height); y-- > 0;) {
    for (std::size_t at = row * y; at < row * (y + 1); at += 4) {
      for (std::size_t channel = 0; channel < 3; ++channel) image.rgb[written++] = rgba[at + channel];
    }
  }
  return image;
}

}  // namespace ghostforce::gl
