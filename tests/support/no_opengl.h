// A machine without OpenGL in software, or without one way to it, for a program that a test starts: the libraries of
// these names are another one.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "tests/support/temporary_folder.h"

namespace ghostforce {

inline constexpr const char* egl_library = "libEGL.so.1";
inline constexpr const char* osmesa_library = "libOSMesa.so.8";

// Newer versions of Mesa lack it (packages.txt).
inline bool has_osmesa() {
  return dlopen(osmesa_library, RTLD_LAZY) != nullptr;
}

class NoOpenGl {
 public:
  explicit NoOpenGl(std::initializer_list<const char*> libraries = {egl_library, osmesa_library}) {
    Dl_info library{};
    if (dladdr(reinterpret_cast<void*>(&dlopen), &library) == 0) throw std::runtime_error("no C library");
    for (const char* const name : libraries) {
      std::filesystem::create_symlink(std::filesystem::canonical(library.dli_fname), folder_ / name);
    }
  }

  // NAME=VALUE
  std::string variable() const { return "LD_LIBRARY_PATH=" + folder_.path(); }

 private:
  TemporaryFolder folder_;
};

}  // namespace ghostforce
