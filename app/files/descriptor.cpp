#include "app/files/descriptor.h"

#include <unistd.h>

namespace ghostforce {

void Descriptor::reset(int number) noexcept {
  if (number_ >= 0) close(number_);
  number_ = number;
}

}  // namespace ghostforce
