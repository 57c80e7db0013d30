// Force and drift at rest over one setting: the wall's angle, or the tracking ratio. The curves are the closed forms,
// rings mark them at the setting in use, shapes what the simulation does there. The operating point can be dragged, and
// the scene follows.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/picture/text.h"
#include "app/widgets/controls.h"
#include "app/workbench/drawer.h"
#include "app/workbench/equilibrium_curves.h"
#include "app/workbench/plot_pieces.h"
#include "app/workbench/ratio_dial.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;

// What is drawn over the setting.
struct EquilibriumQuantity {
  const char* title;
  std::string_view sentence;
  double (*of)(const EquilibriumValue&);  // in the unit of the title
  double smallest_range;
};
constexpr std::array quantities{
    EquilibriumQuantity{"force along the actuated direction [N]",
                        "At rest, from the closed form. Positive values point along the actuated direction. Without a "
                        "ghost force, all three strategies push equally hard.",
                        [](const EquilibriumValue& value) { return value.force; }, 1.0},
    EquilibriumQuantity{"proxy drift along the wall [mm]",
                        "At rest, from the closed form: how far the proxy has drifted from the goal. Where the curve "
                        "crosses 0, nothing drags the hand along the wall.",
                        [](const EquilibriumValue& value) { return mm_per_m * value.drift; }, 1.0},
};

struct EquilibriumAxis {
  std::vector<double> at;  // on the axis, one per value of the curves
  double now;
  double least;
  double greatest;
  bool is_logarithmic;
  std::vector<double> ticks;
  std::vector<std::string> labels;  // of the ticks
};

// The same ring and shape on both plots, so that one sees force and drift of one moment.
void draw_points(const PanelContext& context, const EquilibriumQuantity& quantity, const EquilibriumAxis& axis,
                 const EquilibriumQuestion& question) {
  for_each_strategy(context, [&](StrategyId id) {
    draw_strategy_point(context, id, axis.now, quantity.of(equilibrium_value(id, question)), true);
    if (question.goal_is_inferred) return;
    const StrategySnapshot<2>& now = context.snapshot.strategies[index_of(id)];
    draw_strategy_point(context, id, axis.now, quantity.of(value_now(now.force, now.proxy_drift, question.settings)),
                        false);
  });
}

// Where the person drags the operating point to, if so: these plots have nothing else to take hold of, so that a drag
// may begin anywhere in them, as in the scene.
std::optional<double> draw_operating_point(const PanelContext& context, const EquilibriumAxis& axis) {
  draw_upright_line(context, axis.now, 1.5F);
  bool& is_held = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("held"));
  if (ImPlot::IsPlotHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) is_held = true;
  }
  is_held = is_held && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  return is_held ? std::optional(ImPlot::GetPlotMousePos().x) : std::nullopt;
}

std::optional<double> draw_rest_plot(const PanelContext& context, const EquilibriumQuantity& quantity,
                                     const EquilibriumCurves& curves, const EquilibriumAxis& axis,
                                     const EquilibriumQuestion& question, ImVec2 size) {
  std::optional<double> dragged;
  if (!ImPlot::BeginPlot("##plot", size, quiet_plot)) return dragged;
  PerStrategy<std::vector<double>> heights;
  double least = 0.0;
  double greatest = 0.0;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    for (const EquilibriumValue& value : curves.values[i]) heights[i].push_back(quantity.of(value));
    for (const double height : heights[i]) {
      least = std::fmin(least, height);
      greatest = std::fmax(greatest, height);
    }
  }
  const PlotRange range = roomy(least, greatest, quantity.smallest_range);
  constexpr ImPlotAxisFlags fixed_axis =
      ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoSideSwitch | ImPlotAxisFlags_NoHighlight | ImPlotAxisFlags_Lock;
  ImPlot::SetupAxes(nullptr, nullptr, fixed_axis, fixed_axis);
  if (axis.is_logarithmic) ImPlot::SetupAxisScale(ImAxis_X1, ImPlotScale_Log10);
  set_up_ticks(ImAxis_X1, axis.ticks, axis.labels);
  set_up_ticks(ImAxis_Y1, range, size.y - 2.0F * ImGui::GetTextLineHeight(), "");
  ImPlot::SetupAxesLimits(axis.least, axis.greatest, range.least, range.greatest, ImPlotCond_Always);
  for_each_strategy(context, [&](StrategyId id) { draw_strategy_curve(context, id, axis.at, heights[index_of(id)]); });
  dragged = draw_operating_point(context, axis);
  draw_points(context, quantity, axis, question);
  if (std::isnan(heights.front().front())) {
    const double middle =
        axis.is_logarithmic ? std::sqrt(axis.least * axis.greatest) : 0.5 * (axis.least + axis.greatest);
    ImPlot::PlotText(unknown, middle, 0.5 * (range.least + range.greatest));
  }
  ImPlot::EndPlot();
  return dragged;
}

// The two plots, side by side; and where the operating point is dragged to, if so.
std::optional<double> draw_equilibrium_plots(const PanelContext& context, const EquilibriumCurves& curves,
                                             const EquilibriumAxis& axis, const EquilibriumQuestion& question,
                                             const std::string& condition) {
  std::optional<double> dragged;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const auto count = static_cast<float>(quantities.size());
  const ImVec2 size{(room.x - spacing * (count - 1.0F)) / count, room.y - ImGui::GetTextLineHeightWithSpacing()};
  for (const EquilibriumQuantity& quantity : quantities) {
    if (&quantity != quantities.data()) ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::TextUnformatted(quantity.title);
    tooltip(quantity.sentence);
    // The two plots say it where there is room: each plot may be looked at alone.
    const std::string under =
        question.goal_is_inferred ? condition + (condition.empty() ? "" : ", ") + "goal estimated" : condition;
    const float needed = ImGui::GetItemRectSize().x + ImGui::CalcTextSize(under.c_str()).x + ImGui::GetFontSize();
    if (!under.empty() && needed < size.x) {
      ImGui::SameLine();
      text_in(context.theme.faint_text, under);
      tooltip(quantity.sentence);
    }
    ImGui::PushID(quantity.title);
    if (const auto at = draw_rest_plot(context, quantity, curves, axis, question, size)) dragged = at;
    ImGui::PopID();
    ImGui::EndGroup();
  }
  return dragged;
}

// As the panel has it: from −180° to 180°.
std::string angle_words(int degrees) {
  return decimal_text(degrees <= 180 ? degrees : degrees - 360, 0) + "°";
}

std::size_t samples_for(float width) {
  return std::max<std::size_t>(64, static_cast<std::size_t>(width / 4.0F));
}

}  // namespace

void draw_wall_angle_plots(const PanelContext& context) {
  const Settings& settings = context.settings;
  const float width = ImGui::GetContentRegionAvail().x;
  const EquilibriumQuestion question = equilibrium_question(settings, context.snapshot);
  const EquilibriumCurves curves = equilibria_over_wall_angle(question, samples_for(width));
  EquilibriumAxis axis{{}, 0.0, 0.0, 360.0, false, {}, {}};
  const float widest = ImGui::CalcTextSize("−135°").x + ImGui::GetFontSize();
  const int step = 8.0F * widest < 0.5F * width ? 45 : 90;
  for (int tick = 0; tick <= 360; tick += step) {
    axis.ticks.push_back(tick);
    axis.labels.push_back(angle_words(tick));
  }
  for (const double angle : curves.at) axis.at.push_back(angle / radians_per_degree);
  const double remainder = std::fmod(settings.wall_normal_angle, whole_turn);
  axis.now = (remainder < 0.0 ? remainder + whole_turn : remainder) / radians_per_degree;
  const double goal_depth = depth(wall_of(question.settings), question.goal);
  const std::string condition = goal_depth > 0.0
                                    ? fmt::format("at a depth of {} mm", decimal_text(mm_per_m * goal_depth, 1))
                                    : "goal not in the wall";
  if (const auto dragged = draw_equilibrium_plots(context, curves, axis, question, condition)) {
    const double degrees = std::clamp(*dragged, axis.least, axis.greatest);
    const double angle = (ImGui::GetIO().KeyCtrl ? degrees : std::round(degrees)) * radians_per_degree;
    const Session& session = context.session;
    if (session.pointer_moves_goal) {
      context.apply(MoveHandTo{nearest_in_scene(goal_turned_with_wall(session.settings, session.goal, angle))});
      context.apply(LetGoOfHand{});
    }
    context.apply(TurnWallTo{angle});
  }
}

void draw_ratio_plots(const PanelContext& context) {
  const Stiffnesses& stiffnesses = context.settings.stiffnesses;
  const double optimal = optimal_tracking_ratio(stiffnesses.k_r, believed_user_stiffness(stiffnesses));
  const auto [least, greatest] = ratio_range(stiffnesses);
  const float width = ImGui::GetContentRegionAvail().x;
  const EquilibriumQuestion question = equilibrium_question(context.settings, context.snapshot);
  const EquilibriumCurves curves = equilibria_over_ratio(question, least, greatest, samples_for(width));
  EquilibriumAxis axis{curves.at, tracking_ratio(stiffnesses), least, greatest, true, {1.0}, {"1 naïve"}};
  const double decades_per_pixel = std::log(greatest / least) / (0.45 * static_cast<double>(width));
  const auto add_tick = [&](double ratio, std::string label) {
    if (ratio < least || ratio > greatest) return;
    for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
      const float apart = static_cast<float>(std::abs(std::log(ratio / axis.ticks[i])) / decades_per_pixel);
      const float needed =
          0.5F * (ImGui::CalcTextSize(label.c_str()).x + ImGui::CalcTextSize(axis.labels[i].c_str()).x);
      if (apart < needed + 0.7F * ImGui::GetFontSize()) return;
    }
    axis.ticks.push_back(ratio);
    axis.labels.push_back(std::move(label));
  };
  add_tick(optimal, fmt::format("{:.2f} {}", optimal, stiffnesses.believed_k_u ? "believed ρ*" : "ρ*"));
  for (const double ratio : {0.1, 10.0, 100.0, 1000.0, 0.2, 0.5, 2.0, 5.0, 20.0, 50.0, 200.0, 500.0}) {
    add_tick(ratio, fmt::format("{:g}", ratio));
  }
  const auto dragged = draw_equilibrium_plots(context, curves, axis, question, "");
  if (!dragged) return;
  const double snap = static_cast<double>(ratio_snap_points * context.scale) * decades_per_pixel;
  context.apply(
      ChangeStiffnesses{with_ratio(context.session.settings.stiffnesses, std::clamp(*dragged, least, greatest), snap)});
}

}  // namespace ghostforce
