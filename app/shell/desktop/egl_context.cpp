#include "app/shell/desktop/egl_context.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <glad/egl.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/failure.h"

namespace ghostforce {
namespace {

// glad's own loader asks for the default display, which may be one that somebody looks at.
struct Egl {
  PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
  PFNEGLGETERRORPROC get_error = nullptr;
  PFNEGLGETPLATFORMDISPLAYPROC get_platform_display = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;  // null: an EGL that cannot tell devices apart
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;
};

[[noreturn]] void give_up(const std::string& reason) {
  throw Failure(ExitCode::no_display, reason);
}

Egl open_egl() {
  void* const library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) give_up("there is no libEGL.so.1");
  bool has_all = true;
  const auto find = [&]<typename Function>(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    has_all = has_all && function != nullptr;
  };
  Egl egl;
  find(egl.get_proc_address, "eglGetProcAddress");
  find(egl.get_error, "eglGetError");
  find(egl.get_platform_display, "eglGetPlatformDisplay");
  find(egl.initialize, "eglInitialize");
  find(egl.bind_api, "eglBindAPI");
  find(egl.create_context, "eglCreateContext");
  find(egl.make_current, "eglMakeCurrent");
  find(egl.destroy_context, "eglDestroyContext");
  if (!has_all) give_up("libEGL.so.1 is older than EGL 1.5");
  egl.query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.get_proc_address("eglQueryDevicesEXT"));
  egl.query_device_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl.get_proc_address("eglQueryDeviceStringEXT"));
  return egl;
}

// Never closed: graphics drivers do not like to be opened twice.
const Egl& egl() {
  static const Egl functions = open_egl();
  return functions;
}

bool is_software(EGLDeviceEXT device) {
  const char* const extensions = egl().query_device_string(device, EGL_EXTENSIONS);
  return extensions != nullptr &&
         std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

std::vector<EGLDeviceEXT> devices_of(Renderer renderer) {
  if (egl().query_devices == nullptr || egl().query_device_string == nullptr) return {};
  std::array<EGLDeviceEXT, 32> devices{};
  EGLint count = 0;
  if (egl().query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE) return {};
  std::vector<EGLDeviceEXT> found(devices.begin(), devices.begin() + count);
  std::erase_if(found, [renderer](EGLDeviceEXT each) { return is_software(each) != (renderer == Renderer::egl); });
  return found;
}

// A display driver without a card draws with the processor too, so the renderer's name has the last word.
bool draws_in_software(std::string_view renderer_name) {
  constexpr std::array<std::string_view, 3> names{"llvmpipe", "softpipe", "swrast"};
  return std::ranges::any_of(names,
                             [=](std::string_view name) { return renderer_name.find(name) != std::string_view::npos; });
}

std::string renderer_name() {
  const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(egl().get_proc_address("glGetString"));
  const GLubyte* const name = get_string != nullptr ? get_string(GL_RENDERER) : nullptr;
  return name != nullptr ? reinterpret_cast<const char*>(name) : "unknown";
}

struct Opened {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string problem{};  // empty: it is current
};

// The display stays: opening a device takes longer than all else, and the next context finds it open.
Opened open_device(EGLDeviceEXT device, Renderer renderer) {
  constexpr std::array<EGLint, 7> opengl_3_3_core{
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const auto failed = [](std::string_view what) {
    return Opened{.problem = fmt::format("{} (EGL error {:#x})", what, egl().get_error())};
  };
  Opened opened{.display = egl().get_platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr)};
  if (opened.display == EGL_NO_DISPLAY || egl().initialize(opened.display, nullptr, nullptr) != EGL_TRUE) {
    return failed("EGL's driver cannot be opened");
  }
  egl().bind_api(EGL_OPENGL_API);
  opened.context = egl().create_context(opened.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, opengl_3_3_core.data());
  if (opened.context == EGL_NO_CONTEXT) return failed("EGL's driver has no OpenGL 3.3");
  if (egl().make_current(opened.display, EGL_NO_SURFACE, EGL_NO_SURFACE, opened.context) != EGL_TRUE) {
    opened.problem = failed("EGL's driver cannot draw without a window").problem;
  } else if (const std::string name = renderer_name(); draws_in_software(name) != (renderer == Renderer::egl)) {
    opened.problem = fmt::format("what EGL offers turns out to be {}", name);
  }
  return opened;
}

void close_context(EGLDisplay display, EGLContext context) {
  if (context == EGL_NO_CONTEXT) return;
  egl().make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  egl().destroy_context(display, context);
}

}  // namespace

EglContext::EglContext(Renderer renderer) {
  std::string problem = renderer == Renderer::egl ? "EGL has no software renderer" : "EGL knows of no graphics card";
  for (EGLDeviceEXT device : devices_of(renderer)) {
    Opened opened = open_device(device, renderer);
    if (opened.problem.empty()) {
      display_ = opened.display;
      context_ = opened.context;
      return;
    }
    close_context(opened.display, opened.context);
    problem = std::move(opened.problem);
  }
  give_up(problem);
}

EglContext::~EglContext() {
  close_context(display_, context_);
}

EglContext::Loader EglContext::loader() {
  return egl().get_proc_address;
}

}  // namespace ghostforce
