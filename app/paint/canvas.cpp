#include "app/paint/canvas.h"

#include <algorithm>

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

}  // namespace ghostforce::gl
