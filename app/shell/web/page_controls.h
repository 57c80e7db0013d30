// PageControls: the stage's words and controls (app/stage/stage_controls.h) as elements of the page, beside the canvas:
// what the page's script page_controls.js is told of them, and what becomes of a control that somebody uses. Main
// thread.
#pragma once

#include <string>
#include <string_view>

#include "app/shell/application.h"
#include "app/stage/stage_controls.h"

namespace ghostforce {

class PageControls {
 public:
  // Tells the script, if anything has changed. `is_later`: enough time has passed since the look before.
  void show(Application& application, bool is_later);

  // Somebody has used the control of this id; of a range, `value` is where it has been moved. What cannot be done is
  // told, and the next show() shows the control as it is.
  void use(Application& application, std::string_view id, double value);

  // A control has been used since the last show().
  bool has_news() const noexcept { return has_news_; }

 private:
  SettledTexts texts_;
  std::string shown_;
  bool has_news_ = false;
};

}  // namespace ghostforce
