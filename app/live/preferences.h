// What the program remembers from one run to the next: preferences in the XDG config folder, the layout of the window
// in the XDG state folder, a small TOML file each. A damaged file is set aside under another name; one that cannot be
// read stays where it is. Neither is overwritten, and neither is a reason not to start. UI thread.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace ghostforce {

struct Preferences {
  Appearance appearance{};
  bool offers_hints = true;  // until they have been followed or declined
  Face face = Face::stage;   // that was left last

  friend bool operator==(const Preferences&, const Preferences&) = default;
};

struct WindowLayout {
  int width = 1280;  // [screen coordinates], while neither maximised nor full screen
  int height = 800;
  bool is_maximized = false;
  std::set<std::string, std::less<>> folded_panels{};

  friend bool operator==(const WindowLayout&, const WindowLayout&) = default;
};

struct StoredPreferences {
  Preferences preferences;
  std::optional<WindowLayout> layout;  // empty: nothing is known yet
  std::vector<std::string> remarks;    // for the person: what was damaged, and where it is now
};
StoredPreferences load_preferences();

// Throws Failure(file_trouble). Without a home folder nothing is remembered.
void save(const Preferences& preferences);
void save(const WindowLayout& layout);

}  // namespace ghostforce
