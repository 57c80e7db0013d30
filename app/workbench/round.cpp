// Round and round in numbers: what rendering gives to a hand that goes round a circle inside the wall, beside the formula.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include <glm/common.hpp>

#include "app/picture/text.h"
#include "app/state/mode_changes.h"
#include "app/widgets/controls.h"
#include "app/workbench/panel_catalog.h"
#include "core/conventions.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// One button in one place, whatever the state.
void draw_switch(const PanelContext& context) {
  const bool is_on = context.session.circle_test.is_on;
  const float width = button_width("Go round and round");
  if (ImGui::Button(is_on ? "Stop###circle" : "Go round and round###circle", {width, 0.0F})) {
    context.apply(is_on ? Action(EndCircleTest{}) : BeginCircleTest{});
  }
  tooltip(is_on ? "Returns the goal to where it was, and to what moved it before."
                : "The goal goes round a circle inside the wall, and each turn is measured.");
  if (!is_on) wrapped_text(english_stage.modes.round.about);
}

constexpr double least_mm = 2.0;
constexpr double most_mm = 50.0;

// Of a circle that is all in the picture, in steps of a tenth of a millimetre [m].
double greatest_radius(const Session& session) {
  const Wall<2> wall = wall_near(session.settings, session.goal);
  // Whatever the window's shape, this part of the world is shown.
  const Vector<2> reach = 0.5 * session.shown.width * Vector<2>(1.0, 0.75);
  const auto fits = [&](double mm) {
    const Circle circle = circle_inside(wall, session.goal, {.radius = 0.001 * mm});
    const Vector<2> farthest = glm::abs(circle.center - session.shown.center) + circle.radius;
    return farthest.x <= reach.x && farthest.y <= reach.y;
  };
  long tenths = std::lround(10.0 * least_mm);
  while (tenths < std::lround(10.0 * most_mm) && fits(0.1 * static_cast<double>(tenths + 1))) ++tenths;
  return 1e-4 * static_cast<double>(tenths);
}

void draw_choice(const PanelContext& context, const Circle& circle) {
  CircleChoice choice = context.session.circle_test.choice;
  if (!begin_rows("circle", context)) return;
  row("Direction",
      "In one direction the wall gives energy. In the other it takes as much away, if the device's loop has the same "
      "area. For the same circle of the goal the loops differ slightly, and so do the energies.");
  bool is_changed = ImGui::Checkbox("clockwise", &choice.is_clockwise);
  row("Radius",
      "The radius of the goal's circle, up to the size of the view. A circle that does not fit inside the wall is "
      "moved deeper.");
  double mm = mm_per_m * circle.radius;
  if (slider("##radius", mm, {least_mm, mm_per_m * greatest_radius(context.session)}, "%.1f mm")) {
    choice.radius = 0.001 * mm;
    is_changed = true;
  }
  if (is_changed) context.apply(ChangeCircle{choice});
  end_rows();
}

// Seven characters, or eight from a metre's circle on.
std::string shown(double value, int decimals) {
  return fmt::format("{:>7}", decimal_text(value, decimals));
}

void head(const char* title, const char* unit, Term term) {
  ImGui::TableNextColumn();
  ImGui::BeginGroup();
  ImGui::TextUnformatted(title);
  ImGui::TextUnformatted(unit);
  ImGui::EndGroup();
  tooltip(term);
}

void draw_table(const PanelContext& context, const CircleReading& reading) {
  if (!ImGui::BeginTable("turns", 5, ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX)) return;
  ImGui::TableSetupColumn("strategy", ImGuiTableColumnFlags_WidthFixed, 2.6F * ImGui::GetFontSize());
  ImGui::TableNextColumn();
  head("     area", "      mm²", Term::loop_area);
  head("     last", "      mJ", Term::loop_energy);
  head("     mean", "      mJ", Term::loop_energy);
  head("formula", "      mJ", Term::loop_formula);
  for (const Strategy& entry : strategy_catalog()) {
    const std::size_t i = index_of(entry.id);
    const CircleEnergy& energy = reading.strategies[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    draw_strategy_name(context, entry, context.fonts.regular);
    if (reading.turns == 0) {
      for (int column = 0; column < 4; ++column) number_cell(context, "      —");
      continue;
    }
    number_cell(context, shown(1e6 * energy.mean.area, 2));
    number_cell(context, shown(1e3 * energy.last.energy, 2));
    number_cell(context, shown(1e3 * energy.mean.energy, 2));
    number_cell(context, energy.stays_inside ? shown(1e3 * energy.predicted, 2) : "      —");
    if (!energy.stays_inside) tooltip("The device left the wall, so the formula does not hold.");
  }
  ImGui::EndTable();
}

}  // namespace

void draw_round(const PanelContext& context) {
  draw_switch(context);
  if (!context.loop.circle) return;
  const CircleReading& reading = *context.loop.circle;
  draw_choice(context, reading.circle);
  draw_table(context, reading);
  ImGui::TextUnformatted(fmt::format("{:3} {} measured, {:3.0f} % of the next", reading.turns,
                                     reading.turns == 1 ? "turn" : "turns", 100.0 * reading.share)
                             .c_str());
  tooltip("A turn takes 4 s of model time. Changing a setting or the circle starts over.");
}

}  // namespace ghostforce
