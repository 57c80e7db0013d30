#include "app/paint/embedded_shader.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "embedded_shaders.h"

namespace ghostforce {

std::string_view embedded_shader(std::string_view name) {
  const auto found = std::find_if(embedded_shaders.begin(), embedded_shaders.end(),
                                  [&](const auto& text) { return text.name == name; });
  if (found == embedded_shaders.end()) throw std::logic_error("no embedded shader " + std::string(name));
  return found->contents;
}

}  // namespace ghostforce
