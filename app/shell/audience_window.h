// AudienceWindow: a second window, which shows a picture alone to those who only watch. What a platform does is for a
// class of its own; the page has none. UI thread.
#pragma once

#include <vector>

#include "app/picture/camera.h"
#include "app/picture/panes.h"
#include "app/picture/theme.h"

namespace ghostforce {

class AudienceWindow {
 public:
  virtual ~AudienceWindow() = default;

  // Somebody has closed it.
  virtual bool should_close() const = 0;
  // Of its picture [points]; 0×0 while minimised.
  virtual Vector<2> size() const = 0;
  // The next picture, without panes an empty one. Within a frame of the first window, which then has the letters.
  virtual void prepare(std::vector<Pane> panes, const Theme& theme) = 0;
  // Shows it. After that frame.
  virtual void show() = 0;
};

}  // namespace ghostforce
