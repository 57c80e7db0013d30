// The circle test: leads the circle along with the wall, and measures what each turn makes of energy.
#include "app/shell/input_link.h"
#include "app/state/mode_changes.h"
#include "app/workbench/panel_catalog.h"
#include "core/loop_energy.h"
#include "core/scene_shape.h"
#include "device/input/circle_input.h"

namespace ghostforce {
namespace {

class CircleInputLink final : public InputLink {
 public:
  CircleInputLink(CircleInput& input, const Scene&, const InputOptions&) : input_(input) {}

  void begin(Session& session) override {
    session.folded_panels.erase(std::string(round_panel));
    // The sense that is worth seeing: a wall that is rendered naïvely gives energy to the hand.
    session.circle_test.choice.is_clockwise = makes_energy_clockwise(flattened(session.settings, session.goal));
    session.circle_test.is_on = true;
    session.circle_test.has_news = true;
    measure(session);
  }

  void add(const Snapshot& snapshot) override { meter_.add(snapshot); }
  void fill(LoopReading& reading) const override { reading.circle = meter_.reading(); }

  void send(Session& session, double /*interval_s*/) override {
    // The circle lies in the wall as it is now. While the wall is being turned it waits.
    const Circle circle = circle_of(session);
    if (circle != sent_circle_ && !session.is_editing) {
      input_.go_round(circle);
      sent_circle_ = circle;
      ++session.restarts_asked;
    }
    // All strategies are measured, whichever is the active one.
    settings_.active = session.settings.active;
    if (session.settings != settings_ || session.restarts_asked != restarts_) measure(session);
  }

 private:
  void measure(const Session& session) {
    settings_ = session.settings;
    restarts_ = session.restarts_asked;
    meter_.start(settings_, sent_circle_);
  }

  CircleInput& input_;
  Circle sent_circle_;
  CircleEnergyMeter meter_;
  // What the meter measures.
  Settings settings_;
  std::uint32_t restarts_ = 0;
};

const InputMaker<CircleInput> circle_kind{
    {circling_hand}, [](const Scene& scene, const InputOptions&) {
      return std::make_unique<CircleInput>(
          circle_inside(wall_near(scene.settings, scene.goal.points.back()), scene.goal.points.back(), {}));
    }};

}  // namespace

InputEntry circle_entry() {
  return linked<CircleInputLink>(circle_kind);
}

}  // namespace ghostforce
