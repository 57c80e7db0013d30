// ClipSaving: the last seconds of the stage on their way into a file. What they showed is copied when it begins; then a
// worker beside the window, which sees nothing else, draws and writes picture after picture, so that neither the window
// nor the servo waits for it. UI thread, but for the worker within.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/worker.h"
#include "app/files/clip_file.h"
#include "app/paint/file_painter.h"
#include "app/picture/moment_history.h"
#include "app/stage/stage_clip.h"
#include "app/state/action.h"

namespace ghostforce {

// Those of the clip, evenly, the last one last; fewer where there are no moments so old. After the last change to be
// seen only the change of a strategy is waited for, not for a picture that stands still.
std::vector<ClipMoment> clip_moments(const MomentHistory& moments, const SaveClip& request);

class ClipSaving {
 public:
  ClipSaving() = default;
  ClipSaving(const ClipSaving&) = delete;
  ClipSaving& operator=(const ClipSaving&) = delete;
  // What is not complete leaves nothing.
  ~ClipSaving() { cancel(); }

  // Throws Failure: where the file can never come to be, where there is nothing to save, and where the last clip is not
  // complete yet. `scene`: that the moments are of. `text`: what the file says of itself.
  void begin(const SaveClip& request, const Scene& scene, const MomentHistory& moments, StageClipLook look,
             const FilePainter& painter, std::string_view text);

  // Often: tells the person in the session's notice how far it is and how it has ended. Whoever closes that notice
  // hears of the end alone.
  void poll(Session& session);

  bool is_running() const noexcept { return worker_.has_value(); }

 private:
  struct Work {
    std::vector<ClipMoment> moments;
    StageClipLook look;
    FilePainter painter;
    double interval_s;
    std::unique_ptr<ClipFile> file;
    StageClip clip;
  };
  // What the worker does: the next picture, or after the last one the end. False: that was it.
  bool save_next() noexcept;
  bool save_next_of(Work& work);
  void cancel() noexcept;
  void tell(Session& session, std::string words, bool is_problem);

  std::string path_;
  std::size_t count_ = 0;  // of pictures
  std::string told_;       // the words of the newest notice
  bool is_told_ = false;   // that is still the session's, as far as is known
  bool is_closed_ = false;

  std::atomic<std::size_t> saved_{0};
  std::atomic<bool> is_cancelled_{false};
  // The worker's, until it has ended.
  std::unique_ptr<Work> work_;
  std::string problem_;  // empty: there was none
  std::optional<Worker> worker_;
};

}  // namespace ghostforce
