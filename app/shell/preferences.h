// What the program remembers from one run to the next: preferences in the XDG config folder, the layout of the window
// in the XDG state folder, a small TOML file each (kept_file.h). UI thread.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/state/session.h"

namespace ghostforce {

class Window;

// Of the plots, what does not depend on what they show.
struct PlotPreferences {
  bool is_open = false;
  PlotTab tab = PlotTab::time;
  double span_s = PlotView{}.span_s();

  friend bool operator==(const PlotPreferences&, const PlotPreferences&) = default;
};

// What a person has chosen for good. Not in here, so that no run begins otherwise than one expects: what belongs to the
// scene or to the moment; what moves the goal; and the limits of motors, to which a person agrees anew each time.
struct Preferences {
  Appearance appearance{};
  ScreenMotion motion = ScreenMotion::as_system;
  ViewOptions options{};
  PlotPreferences plots{};
  SpaceMouseSettings spacemouse{};
  Face face = Face::stage;  // that was left last
  double speed = 1.0;
  bool speaks = false;
  bool offers_hints = true;  // until they have been followed or declined
  std::string language{};    // of the stage and of lessons, as "en" or "es"; empty: the environment's

  friend bool operator==(const Preferences&, const Preferences&) = default;
};

// As the session has them, which always has a language.
Preferences preferences_in(const Session& session);
void apply(const Preferences& preferences, Session& session);

struct WindowLayout {
  int width = first_width;  // [screen coordinates], while neither maximised nor full screen
  int height = first_height;
  bool is_maximized = false;
  bool is_full_screen = false;
  std::set<std::string, std::less<>> folded_panels{};

  static constexpr int first_width = 1280;
  static constexpr int first_height = 800;

  friend bool operator==(const WindowLayout&, const WindowLayout&) = default;
};

// The titles of the panels of the workbench that are folded at first in a window so high [points].
std::set<std::string, std::less<>> panels_folded_at_first(double height);

// To what a new person sees; the files follow (PreferenceKeeper).
void reset_preferences(Session& session, Window& window);

struct StoredPreferences {
  Preferences preferences;
  std::optional<WindowLayout> layout;  // empty: nothing is known yet
  std::vector<std::string> remarks;    // for the person: what was damaged, and where it is now
};
StoredPreferences load_preferences();

// What visitors get of it: theme, scale, motion and language were chosen for the machine, all else for a person. Full screen.
StoredPreferences for_visitors(const StoredPreferences& stored);

// What a newer program has written beside it stays in the files. Throws Failure(file_trouble). Without a home folder
// nothing is remembered.
void save(const Preferences& preferences);
void save(const WindowLayout& layout);

// Keeps the stored preferences up to date, beside other windows that do the same. What the command line asked for holds
// for its run only.
class PreferenceKeeper {
 public:
  // `session`: as the run begins.
  PreferenceKeeper(Preferences stored, const Session& session)
      : stored_(std::move(stored)), seen_(preferences_in(session)), resets_(session.preference_resets) {}

  // Adds what the person has changed since the last call, if anything, to what is stored by now; after a reset the
  // files are gone. Throws Failure(file_trouble) where it cannot be stored; then it is stored with the next change.
  void keep(const Session& session);

 private:
  Preferences stored_;
  Preferences seen_;
  std::set<std::string_view> unsaved_;  // keys of the file that this window has changed
  std::uint32_t resets_;                // that have been seen
};

}  // namespace ghostforce
