#include "app/cli/version.h"

#include <fmt/format.h>

#include "ghostforce_build.h"
#include "ghostforce_version.h"

namespace ghostforce {

std::string version_words(std::string_view renderer) {
  return fmt::format(
      "ghostforce {}\n"
      "commit     {}\n"
      "build      {}, {}, {}\n"
      "libraries  {}\n"
      "renderer   {}\n",
      version, build::commit.empty() ? "unknown" : build::commit, build::type, build::compiler, build::system,
      build::libraries, renderer);
}

}  // namespace ghostforce
