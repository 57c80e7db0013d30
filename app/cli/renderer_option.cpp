#include "app/cli/renderer_option.h"

#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/console/quoted.h"

namespace ghostforce {

CLI::Option* attach_renderer(CLI::App& command, std::optional<Renderer>& renderer) {
  std::string words = "What draws";
  const char* separator = ": ";
  for (const RendererEntry& entry : renderer_catalog()) {
    words += fmt::format("{}{}, {}", separator, entry.name, entry.sentence);
    separator = "; ";
  }
  return command
      .add_option_function<std::string>(
          "--renderer", [&renderer](const std::string& name) { renderer = find_renderer(name); },
          words + "; default: egl, or osmesa where it is missing")
      ->type_name("NAME")
      ->check(one_of(names_of(renderer_catalog())));
}

}  // namespace ghostforce
