#include "app/cli/version.h"

#include <utility>

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

ReceiptOrigin receipt_origin(std::string firmware) {
  return {.version = std::string(version),
          .commit = std::string(build::commit),
          .build = fmt::format("{}, {}, {}", build::type, build::compiler, build::system),
          .libraries = std::string(build::libraries),
          .firmware = std::move(firmware)};
}

}  // namespace ghostforce
