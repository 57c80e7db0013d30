#include "app/tools/check/rendered_cases.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/tools/check/case_folder.h"

namespace ghostforce {
namespace {

// Twenty pictures of the usual size. What finds no room is drawn again, and is the same then.
constexpr std::size_t most_kept_bytes = std::size_t{64} << 20;

}  // namespace

RenderedCases::RenderedCases(const std::vector<Case>& all, const std::vector<const Case*>& chosen,
                             std::optional<Renderer> renderer)
    : renderer_(renderer) {
  const auto want = [&](const Case* wanted) {
    Entry& entry = entries_[wanted->name];
    entry.described = wanted;
    ++entry.times_wanted;
  };
  for (const Case* const each : chosen) {
    want(each);
    if (!each->other.empty()) want(find_case(all, each->other));
  }
  std::vector<std::string> problems;
  for (const auto& [name, entry] : entries_) {
    try {
      simulate_to_moment(content_of(*entry.described).request);
    } catch (const Failure& failure) {
      if (failure.code() != ExitCode::wrong_call) throw;
      problems.push_back(fmt::format("{}: {}", quoted_text(entry.described->path, longest_path), failure.what()));
    } catch (const ReadError& error) {
      if (error.kind() != ReadError::Kind::wrong) throw;
      problems.emplace_back(error.what());
    }
  }
  if (!problems.empty()) throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(problems, "\n")));
}

RenderedCase RenderedCases::draw(const std::string& name) {
  Entry& entry = entries_.at(name);
  const bool is_wanted_again = --entry.times_wanted > 0;
  if (const auto kept = kept_.find(name); kept != kept_.end()) {
    if (is_wanted_again) return kept->second;
    RenderedCase drawn = std::move(kept->second);
    kept_.erase(kept);
    kept_bytes_ -= drawn.image.rgb.size();
    return drawn;
  }
  PictureRequest request = content_of(*entry.described).request;
  request.renderer = renderer_;
  // A window of its own for each: what is drawn cannot depend on what was drawn before.
  const Moment moment = simulate_to_moment(request);
  Drawing drawing = draw_moment(request, moment);
  RenderedCase drawn{std::move(drawing.image), present_origin(drawing.graphics),
                     moment.snapshot.strategies[index_of(request.scene.settings.active)]};
  if (is_wanted_again && kept_bytes_ + drawn.image.rgb.size() <= most_kept_bytes) {
    kept_bytes_ += drawn.image.rgb.size();
    kept_.emplace(name, drawn);
  }
  return drawn;
}

}  // namespace ghostforce
