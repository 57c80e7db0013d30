// RenderedCases: the pictures of cases, each drawn when it is asked for, and kept only as long as another case will ask
// for it again. Main thread only (OpenGL offscreen).
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/shell/desktop/offscreen.h"
#include "app/tools/check/case_file.h"
#include "core/snapshot.h"

namespace ghostforce {

struct RenderedCase {
  Image image;
  GoldenOrigin origin;
  StrategySnapshot<2> numbers;  // of the active strategy
};

class RenderedCases {
 public:
  // Simulates every scene that will be needed: the chosen cases' and those they are compared with. Throws Failure:
  // wrong_call with all the scenes that cannot be drawn, a line each; interrupted. `all` must outlive this. `renderer`:
  // empty for the usual one.
  RenderedCases(const std::vector<Case>& all, const std::vector<const Case*>& chosen, std::optional<Renderer> renderer);

  std::optional<Renderer> renderer() const noexcept { return renderer_; }

  // `name` is one of the chosen, or one that such a case is compared with; once for each. Throws Failure: no_display,
  // interrupted; what reading the case does.
  RenderedCase draw(const std::string& name);

 private:
  struct Entry {
    const Case* described = nullptr;
    std::size_t times_wanted = 0;  // from now on
  };

  std::optional<Renderer> renderer_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::map<std::string, RenderedCase, std::less<>> kept_;
  std::size_t kept_bytes_ = 0;
};

}  // namespace ghostforce
