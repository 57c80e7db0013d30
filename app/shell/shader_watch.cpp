#include "app/shell/shader_watch.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/input_file.h"
#include "app/paint/shaders.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

constexpr double look_interval_s = 0.25;

std::string contents_of(const fs::path& file) {
  FileContents contents = file_contents(file);
  if (contents.error == 0) return std::move(contents.text);
  throw gl::ShaderError(
      fmt::format("{} cannot be read: {}", file.string(), std::generic_category().message(contents.error)));
}

}  // namespace

ShaderWatch::ShaderWatch(const std::string& folder)
    : files_{fs::path(folder) / "mark.vert", fs::path(folder) / "mark.frag"} {
  for (const fs::path& file : files_) {
    std::error_code error;
    if (fs::is_regular_file(file, error)) continue;
    throw Failure(ExitCode::wrong_call,
                  fmt::format("--shader-dir {}: there is no file {} in it; copy the folder shaders/ of the source tree",
                              quoted_text(folder, longest_path), file.filename().string()));
  }
}

ShaderWatch::Stamps ShaderWatch::stamps() const {
  Stamps stamps;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    // A file that an editor is just replacing has no time; it will have one the next time.
    std::error_code error;
    stamps[i].time = fs::last_write_time(files_[i], error);
    stamps[i].size = fs::file_size(files_[i], error);
  }
  return stamps;
}

bool ShaderWatch::poll(GlPainter& painter, double now_s) {
  if (has_looked_ && now_s < next_look_s_) return false;
  next_look_s_ = now_s + look_interval_s;
  const Stamps now = stamps();
  if (has_looked_ && now == seen_) return false;
  has_looked_ = true;
  seen_ = now;
  try {
    painter.use_shaders(contents_of(files_[0]), contents_of(files_[1]));
    problem_.clear();
  } catch (const gl::ShaderError& error) {
    problem_ = error.what();
  }
  return true;
}

}  // namespace ghostforce
