// What the program would end with, had its work ended like this: 0, or the code of the failure.
#pragma once

#include <functional>

#include "app/base/failure.h"

namespace ghostforce {

inline int exit_code_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Failure& failure) {
    return static_cast<int>(failure.code());
  }
  return 0;
}

}  // namespace ghostforce
