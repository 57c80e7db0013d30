// The experiments in the window: the guided measurement of the hand, and the circle test.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "app/panels/panel_catalog.h"
#include "app/png_file.h"
#include "app/user_measurement_guide.h"
#include "core/energy.h"
#include "core/ghost_force.h"
#include "tests/app/driven_window.h"

namespace ghostforce {
namespace {

class ExperimentsWindow : public DrivenWindow {
 protected:
  // All panels folded but one.
  static ApplicationOptions with_panel(std::string_view open_panel) {
    ApplicationOptions options;
    for (const Panel& panel : panel_catalog()) {
      if (panel.title != open_panel) options.folded_panels.emplace(panel.title);
    }
    return options;
  }
  void save(const std::string& name) {
    if (const char* folder = std::getenv("GF_SHOTS")) {
      std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary) << png_bytes(picture());
    }
  }
};

TEST_F(ExperimentsWindow, Pictures) {
  if (std::getenv("GF_SHOTS") == nullptr) GTEST_SKIP();
  for (const char* theme : {"light", "dark", "projector"}) {
    for (const auto& [w, h] : {std::pair{1280, 800}, std::pair{1024, 640}}) {
      const std::string suffix = std::string(theme) + std::to_string(w);
      ApplicationOptions options;
      options.look.theme = find_theme(theme);
      options.folded_panels = panels_folded_at_first(h);
      options.folded_panels.erase("Measure the hand");
      open(options, "wall45", w, h);
      frames(5);
      save("off-" + suffix);
      session().settings.impedances.believed_k_u = 100.0;
      start_measuring(session());
      frames(40);
      save("nulling-" + suffix);
      take_reading(session());
      for (int i = 0; i < 5; ++i) {
        session().settings.impedances.chosen_tracking_ratio = 4.0 + 0.01 * i;
        frames(60);
        if (i == 2) save("take-" + suffix);
        take_reading(session());
      }
      frames(20);
      save("done-" + suffix);
      options.folded_panels = panels_folded_at_first(h);
      options.input = "circle";
      open(options, "wall45", w, h);
      frames(60, 100);
      session().circle_test.has_news = true;
      frames(80, 100);
      save("energy-" + suffix);
    }
  }
}

}  // namespace
}  // namespace ghostforce
