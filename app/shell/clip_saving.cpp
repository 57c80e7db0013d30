#include "app/shell/clip_saving.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/file_exchange.h"
#include "app/shell/window.h"

namespace ghostforce {
namespace {

// How long a clip goes on after the last change: until the stage has shown a change of the strategy, and a little more.
constexpr double hold_s = 1.0;

struct ClipCancelled {};

}  // namespace

std::vector<ClipMoment> clip_moments(const MomentHistory& moments, const SaveClip& request) {
  std::vector<ClipMoment> chosen;
  if (moments.is_empty()) return chosen;
  const double end_s = std::min({request.end_s, moments.newest()->snapshot.time_s, moments.changed_s() + hold_s});
  const double begin_s = std::max(end_s - request.seconds, moments.oldest()->snapshot.time_s);
  const double interval_s = 1.0 / request.frames_per_second;
  constexpr double rounding = 1e-6;  // of an interval
  const auto steps = static_cast<int>(std::max(0.0, end_s - begin_s) / interval_s + rounding);
  for (int i = steps; i >= 0; --i) {
    // A tick's own time, which rounding must not miss.
    const std::optional<ShownMoment> moment = moments.at(end_s - i * interval_s + rounding * interval_s);
    if (moment) chosen.push_back({moment->settings, moment->snapshot});
  }
  return chosen;
}

void ClipSaving::begin(const SaveClip& request, const Scene& scene, const MomentHistory& moments, StageClipLook look,
                       const FilePainter& painter, std::string_view text) {
  if (is_running()) {
    throw Failure(ExitCode::wrong_call, "Another clip is being saved. Wait until it is complete.");
  }
  auto work = std::make_unique<Work>(Work{.moments = clip_moments(moments, request),
                                          .look = look,
                                          .painter = painter,
                                          .interval_s = 1.0 / request.frames_per_second,
                                          .file = {},
                                          .clip = StageClip(std::move(look))});
  for (ClipMoment& moment : work->moments) {
    moment.settings = settings_at(scene, moment.settings, moment.snapshot.time_s);
  }
  if (work->moments.empty()) throw Failure(ExitCode::wrong_call, "Nothing has happened yet that could be saved.");
  const ClipShape shape{static_cast<int>(std::lround(work->look.size.x)),
                        static_cast<int>(std::lround(work->look.size.y)), request.frames_per_second};
  check_clip_limits(static_cast<std::int64_t>(work->moments.size()), shape);
  is_cancelled_ = false;
  saved_ = 0;
  work->file = std::make_unique<ClipFile>(request.path, shape, text, VideoWaiting{.look_up = [this] {
                                            if (is_cancelled_) throw ClipCancelled();
                                          }});
  path_ = request.path;
  count_ = work->moments.size();
  problem_.clear();
  is_told_ = is_closed_ = false;
  work_ = std::move(work);
  worker_.emplace("clip", 0.0, [this] { return save_next(); });
}

bool ClipSaving::save_next() noexcept {
  try {
    if (save_next_of(*work_)) return true;
  } catch (const ClipCancelled&) {
    // The program ends: there is nobody to tell.
  } catch (const Failure& failure) {
    problem_ = failure.what();
  } catch (const std::bad_alloc&) {
    problem_ = "There is not enough memory for this clip. Choose a shorter one, or make the window smaller.";
  } catch (const std::exception& error) {
    problem_ = fmt::format("The clip could not be saved: {}", error.what());
  }
  work_.reset();  // the file is closed before the end is told
  return false;
}

// False: the file is complete.
bool ClipSaving::save_next_of(Work& work) {
  if (is_cancelled_) throw ClipCancelled();
  const std::size_t number = saved_;
  if (number == count_) {
    work.file->commit();
    return false;
  }
  const std::vector<Pane> panes{work.clip.next(work.moments[number], number == 0 ? 0.0 : work.interval_s)};
  work.file->add(work.painter.image({.panes = panes,
                                     .theme = *work.look.theme,
                                     .size = work.look.size,
                                     .text_scale = text_scale_of(Face::stage, work.look.scale, *work.look.theme),
                                     .title = {}}));
  ++saved_;
  return true;
}

void ClipSaving::tell(Session& session, std::string words, bool is_problem) {
  told_ = words;
  is_told_ = true;
  session.notice = Notice{std::move(words), is_problem, 0.0};
}

void ClipSaving::poll(Session& session) {
  if (!is_running()) return;
  worker_->poll();
  const std::string path = quoted_text(path_, longest_path);
  const StageLanguage::Notices& words = stage_language(session.language).notices;
  if (!worker_->is_running()) {
    worker_.reset();
    if (!problem_.empty()) return tell(session, problem_, true);
    hand_out(path_);
    return tell(session, filled(words.saved, path), false);
  }
  const bool is_mine = session.notice && session.notice->words == told_;
  if (is_told_ && !session.notice) is_closed_ = true;
  // Something else is told meanwhile.
  if (session.notice && !is_mine) is_told_ = false;
  if (is_closed_ || (session.notice && !is_mine)) return;
  constexpr std::size_t step = 5;  // not every picture is worth a new frame
  const std::size_t percent = 100 * saved_ / count_ / step * step;
  tell(session, filled(words.saving, path, percent), false);
}

void ClipSaving::cancel() noexcept {
  is_cancelled_ = true;
  worker_.reset();
}

}  // namespace ghostforce
