#include "app/files/program_build.h"

#include "ghostforce_version.h"

namespace ghostforce {

std::string program_build() {
  return std::string(version);
}

}  // namespace ghostforce
