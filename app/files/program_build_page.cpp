#include "app/files/program_build.h"
#include "ghostforce_version.h"

namespace ghostforce {

// Another compiler and another mathematical library than on a desktop: the last bits may be others.
std::string program_build() {
  return std::string(version) + ", page";
}

}  // namespace ghostforce
