#include "app/check/gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/check/case_folder.h"
#include "app/failure.h"
#include "app/printable.h"

namespace ghostforce {

Gallery::Gallery(const std::vector<Case>& all, const std::vector<const Case*>& chosen) {
  for (const Case* const each : chosen) {
    prepared_[each->name].described = each;
    if (each->other.empty()) continue;
    prepared_[each->other].described = find_case(all, each->other);
    wanted_again_.insert(each->other);
  }
  std::vector<std::string> problems;
  for (auto& [name, prepared] : prepared_) {
    try {
      prepared.moment = play_to_moment(prepared.described->request);
    } catch (const Failure& failure) {
      if (failure.code() != ExitCode::wrong_call) throw;
      problems.push_back(fmt::format("{}: {}", printable(prepared.described->path, longest_path), failure.what()));
    }
  }
  if (!problems.empty()) throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(problems, "\n")));
}

DrawnCase Gallery::draw(const std::string& name) {
  if (const auto kept = kept_.find(name); kept != kept_.end()) return kept->second;
  const Prepared& prepared = prepared_.at(name);
  // A window of its own for each: what is drawn cannot depend on what was drawn before.
  Drawing drawing = draw_moment(prepared.described->request, prepared.moment);
  DrawnCase drawn{std::move(drawing.image), present_origin(drawing.graphics)};
  if (wanted_again_.contains(name)) kept_.emplace(name, drawn);
  return drawn;
}

}  // namespace ghostforce
