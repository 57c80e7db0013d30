// StageControls: the stage for whoever does not see it or has a keyboard alone: what it says and what can be done there,
// as a tree of words and controls, each with an id that stays the same and with the Actions that it leads to. Made of the
// tables that keys, buttons and the palette are made of. A front shows the tree by the means of its system. Values; pure;
// UI thread.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/stage/stage.h"
#include "app/stage/stage_control.h"
#include "app/state/session.h"

namespace ghostforce {

// As things are, in the order of reading.
std::vector<StageControl> stage_controls(const Session& session, const LoopReading& loop, const StageReading& reading);

// Null where there is none of that id.
const StageControl* find_control(std::span<const StageControl> controls, std::string_view id) noexcept;

// Keeps back the texts that are told while they change: those that stand together become what they are together, once
// two looks have found them all the same. Of what goes on changing, the newest is told now and then.
class SettledTexts {
 public:
  // `is_later`: enough time has passed since the look before for something that changes to have changed, and nothing is
  // on its way from one strategy to another.
  void settle(std::vector<StageControl>& controls, bool is_later);

 private:
  static constexpr int most_unsettled_looks = 7;  // the next one tells

  struct Text {
    std::string seen;
    std::string told;
    int unsettled_looks = 0;  // since it was told
  };
  using Texts = std::map<std::string, Text, std::less<>>;  // by id

  void settle(std::vector<StageControl>& controls, bool is_later, Texts& settled) const;

  Texts texts_;
};

}  // namespace ghostforce
