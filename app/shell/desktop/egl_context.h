// EglContext: OpenGL without a display and without a window, by EGL, on a device that is named: Mesa's software
// renderer or a graphics card. libEGL is opened when the first of them is made, so that the program also starts without
// it. It has no framebuffer of its own: what is drawn needs a gl::Canvas. Main thread only.
#pragma once

#include "app/shell/desktop/renderer.h"

namespace ghostforce {

class EglContext {
 public:
  // OpenGL 3.3 core, current from here on; `renderer` is egl or gpu. Throws Failure(no_display) with the reason alone.
  explicit EglContext(Renderer renderer);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  // Finds OpenGL's functions.
  using Loader = void (*(*)(const char* name))();
  static Loader loader();

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace ghostforce
