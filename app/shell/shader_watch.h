// Shader watch: looks whether the shaders in a folder have changed, compiles them beside the running program and puts
// them in place only where that succeeds. For people who work on the picture. On the thread that holds the context.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "app/paint/gl_painter.h"

namespace ghostforce {

class ShaderWatch {
 public:
  // Throws Failure(wrong_call) where the folder does not hold the shaders.
  explicit ShaderWatch(const std::string& folder);

  // Often; looks at the files four times a second. True: they are others than the last time. `now_s`: seconds on any
  // clock that only goes forward.
  bool poll(GlPainter& painter, double now_s);

  // Why the newest shaders are not in use: the driver's log and the numbered source. Empty: they are.
  const std::string& problem() const noexcept { return problem_; }

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  using Stamps = std::array<Stamp, 2>;
  Stamps stamps() const;

  std::array<std::filesystem::path, 2> files_;  // vertex, fragment
  Stamps seen_{};
  bool has_looked_ = false;
  double next_look_s_ = 0.0;
  std::string problem_;
};

}  // namespace ghostforce
