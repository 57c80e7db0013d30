// A machine without OpenGL in software, for a program that a test starts: the library of that name is another one.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/support/temporary_folder.h"

namespace ghostforce {

class NoOpenGl {
 public:
  NoOpenGl() {
    Dl_info library{};
    if (dladdr(reinterpret_cast<void*>(&dlopen), &library) == 0) throw std::runtime_error("no C library");
    std::filesystem::create_symlink(std::filesystem::canonical(library.dli_fname), folder_ / "libOSMesa.so.8");
  }

  // NAME=VALUE
  std::string variable() const { return "LD_LIBRARY_PATH=" + folder_.path(); }

 private:
  TemporaryFolder folder_;
};

}  // namespace ghostforce
