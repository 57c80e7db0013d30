#include "app/picture/glossary.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr std::array entries{
    GlossaryEntry{Term::goal, "Goal q_u",
                  "Where your hand wants the device to be. Drag it. On the stage it is the hand.", "", "mm"},
    GlossaryEntry{
        Term::device, "Device q_h",
        "Where the device is. The hand pulls it towards the goal, and its motors push back. On the stage it is the "
        "handle.",
        "k_u (q_u − q_h) + f_r = 0 at rest", "mm"},
    GlossaryEntry{
        Term::proxy, "Proxy q_p",
        "Where the device should be. The wall holds this point back, and the motors pull the device towards it. On the "
        "stage it is the hollow mark.",
        "K_t (q_h − q_p) + k_c (q_c − q_p) = 0", "mm"},
    GlossaryEntry{Term::contact, "Contact q_c", "The point on the wall that is nearest to the proxy.",
                  "q_c = q_p + n (n·(o − q_p))", "mm"},
    GlossaryEntry{
        Term::wall, "Virtual wall",
        "The hatched side is solid: the device belongs on the other side. Drag the round grips to turn the wall.",
        "n·(q − o) ≥ 0", ""},
    GlossaryEntry{Term::force, "Rendered force f_r", "How hard the device pushes on the hand.", "f_r = K_r (q_p − q_h)",
                  "N"},
    GlossaryEntry{Term::ghost_force, "Ghost force",
                  "How much harder the device pushes along its actuated direction than a fully actuated device would. "
                  "It should be zero.",
                  "P_A (f_r − f_r of F)", "N"},
    GlossaryEntry{Term::proxy_drift, "Proxy drift (slide)",
                  "How far the proxy has slid along the wall, away from where the hand aims. It should be zero. The "
                  "stage calls it the slide.",
                  "(q_p − q_u) along the wall", "mm"},
    GlossaryEntry{
        Term::energy, "Energy",
        "How much energy the rendering has given to the hand since the last reset. Over a closed loop it should be "
        "zero. Above zero, the rendering was active, not passive.",
        "Σ f_r,k−1 · (q_h,k − q_h,k−1)", "mJ"},
    GlossaryEntry{Term::model_error, "Model − simulation",
                  "How far the simulated devices are from where the closed forms say that they come to rest.",
                  "max |q_h − q_h of the paper's (9) to (20)|", "mm"},
    GlossaryEntry{
        Term::prediction, "Prediction",
        "Where the closed form says that the device and the proxy come to rest. The simulation gets there on its own.",
        "equations (9) to (20) of the paper", "mm"},
    GlossaryEntry{Term::trail, "Trail", "Where the goal (dots) and the devices have been in the last 3 seconds.", "",
                  "mm"},
    GlossaryEntry{Term::hand_spring, "Hand", "The spring that pulls the device to the hand's goal.",
                  "f_u = k_u (q_u − q_h)", "N"},
    GlossaryEntry{Term::tracking_link, "Tracking", "The spring that makes the proxy follow the device.",
                  "f_t = K_t (q_h − q_p)", "N"},
    GlossaryEntry{Term::motor_axis, "Actuated direction",
                  "The direction in which the device can push. It has no motor across it. Drag the arrow to turn it. "
                  "On the stage it is the rail.",
                  "counter-clockwise from x", "°"},
    GlossaryEntry{Term::wall_normal, "Wall normal n", "The direction in which the wall faces.",
                  "counter-clockwise from x", "°"},
    GlossaryEntry{Term::rendering_stiffness, "Rendering stiffness k_r",
                  "The stiffness of the spring that pulls the device towards the proxy, in the actuated directions.",
                  "f_r = K_r (q_p − q_h)", "N/m"},
    GlossaryEntry{Term::tracking_stiffness, "Tracking stiffness k_t",
                  "The stiffness of the spring that makes the proxy follow the device, in the actuated directions.",
                  "f_t = K_t (q_h − q_p)", "N/m"},
    GlossaryEntry{Term::constraint_stiffness, "Constraint stiffness k_c",
                  "The stiffness of the spring with which the wall holds the proxy back.", "f_c = k_c (q_c − q_p)",
                  "N/m"},
    GlossaryEntry{Term::hard_constraint, "Hard constraint", "The proxy never enters the wall.", "k_c = ∞", ""},
    GlossaryEntry{Term::tracking_ratio, "Tracking ratio ρ",
                  "How much more stiffly the proxy follows the device along the actuated direction than across it. 1 "
                  "is naïve; ρ* removes the ghost force. Only anisotropic rendering uses it.",
                  "ρ = k_ta / k_tn,  ρ* = 1 + k_r / k_u", ""},
    GlossaryEntry{Term::user_stiffness, "User stiffness k_u", "How stiffly the hand holds its goal.",
                  "f_u = k_u (q_u − q_h)", "N/m"},
    GlossaryEntry{Term::believed_user_stiffness, "Believed user stiffness",
                  "The k_u that the renderer uses to compute ρ*. If it is wrong, the drift comes back.",
                  "ρ* = 1 + k_r / believed k_u", "N/m"},
    GlossaryEntry{Term::right_belief, "Same", "The renderer knows the hand's true stiffness.", "believed k_u = k_u",
                  ""},
    GlossaryEntry{Term::force_scale, "Scale", "How long a force and a distance are drawn.", "", "N, mm"},
    GlossaryEntry{
        Term::target, "Target",
        "Aim here: press straight into the wall. Ghost force and drift are then measured relative to the target.", "",
        ""},
    GlossaryEntry{
        Term::drift_of_belief, "Anisotropic drift",
        "How far the anisotropic proxy still drifts along the wall. If the belief is right, it does not drift.",
        "(q_p − q_u) along the wall", "mm"},
    GlossaryEntry{Term::null_drift, "Drift to be nulled",
                  "How far the proxy has drifted along the wall from the goal. Above zero, ρ is too low.",
                  "(λ/k_t) (1 + k_r/k_u − ρ) √(α (1 − α)),  α = nᵀP_A n", "mm"},
    GlossaryEntry{Term::drift_from_target, "Drift to be nulled",
                  "How far the proxy has drifted along the wall from the target. Above zero, ρ is too low.",
                  "(λ/k_t) (1 + k_r/k_u − ρ) √(α (1 − α)),  α = nᵀP_A n", "mm"},
    GlossaryEntry{Term::null_ratio, "Ratio ρ° without drift",
                  "Where the drift vanishes, ρ is optimal, and k_u follows from it.", "k_u = k_r / (ρ° − 1)", ""},
    GlossaryEntry{Term::loop_area, "Area of the loop",
                  "The area that the path of the device (not the goal) encloses in one turn, on average. Above zero: "
                  "counter-clockwise.",
                  "S = ½ Σ q_h,k−1 × q_h,k", "mm²"},
    GlossaryEntry{
        Term::loop_energy, "Energy per turn",
        "How much energy the rendering gave to the hand in the last turn, and on average. Above zero, it was active. "
        "The delay of the sampled loop makes it slightly lower.",
        "Σ f_r,k−1 · (q_h,k − q_h,k−1)", "mJ"},
    GlossaryEntry{Term::loop_formula, "Energy from the formula",
                  "For a slow loop of the same area. θ is the angle from n to the actuated direction. With full "
                  "actuation it is zero.",
                  "−k_r sinθ cosθ S / (cos²θ + ρ sin²θ + k_t/k_c)", "mJ"},
    GlossaryEntry{
        Term::estimated_goal, "Goal q_u, estimated",
        "Where the hand seems to want the device to be. Nobody can measure this, so it is estimated from the force "
        "and the believed k_u.",
        "q_h − f_r / believed k_u", "mm"},
    GlossaryEntry{Term::live_user_stiffness, "Hand, measured live",
                  "How stiff the hand is along the motor, not across it, while tones of 3 and 16 Hz shake the handle a "
                  "little (about 0.7 mm). The band is one standard deviation. It is the stiffness at 3 Hz: a hand that "
                  "creeps reads up to 24 % too stiff.",
                  "k_u = Re Z(3 Hz) + ω² m,  Z = F/X", "N/m"},
    GlossaryEntry{Term::given_user_stiffness, "Hand k_u, given",
                  "The stiffness that the simulated hand was given. Of a real hand nobody knows it.", "", "N/m"},
    GlossaryEntry{Term::live_ratio, "Ratio of the hand, measured live",
                  "Where ρ would be optimal for the hand as it is measured live; the bar is one standard deviation of "
                  "k_u to either side.",
                  "ρ* = 1 + k_r / k_u", ""},
};

struct RoleEntry {
  Role id;
  std::string_view name;
  std::optional<Term> term;
};
constexpr std::array roles{
    RoleEntry{Role::wall, "wall", Term::wall},
    RoleEntry{Role::hatching, "hatching", Term::wall},
    RoleEntry{Role::grid, "grid", std::nullopt},
    RoleEntry{Role::motor_axis, "motor_axis", Term::motor_axis},
    RoleEntry{Role::trail, "trail", Term::trail},
    RoleEntry{Role::hand_spring, "hand_spring", Term::hand_spring},
    RoleEntry{Role::tracking_link, "tracking_link", Term::tracking_link},
    RoleEntry{Role::goal, "goal", Term::goal},
    RoleEntry{Role::device, "device", Term::device},
    RoleEntry{Role::proxy, "proxy", Term::proxy},
    RoleEntry{Role::contact, "contact", Term::contact},
    RoleEntry{Role::force, "force", Term::force},
    RoleEntry{Role::ghost_force, "ghost_force", Term::ghost_force},
    RoleEntry{Role::proxy_drift, "proxy_drift", Term::proxy_drift},
    RoleEntry{Role::prediction, "prediction", Term::prediction},
    RoleEntry{Role::handle, "handle", Term::wall},
    RoleEntry{Role::scale, "scale", Term::force_scale},
    RoleEntry{Role::legend, "legend", std::nullopt},
    RoleEntry{Role::target, "target", Term::target},
    RoleEntry{Role::hand, "hand", std::nullopt},
    RoleEntry{Role::wall_share, "wall_share", std::nullopt},
    RoleEntry{Role::expected_rest, "expected_rest", std::nullopt},
    RoleEntry{Role::expected_contact, "expected_contact", std::nullopt},
    RoleEntry{Role::guess, "guess", std::nullopt},
    RoleEntry{Role::area, "area", std::nullopt},
    RoleEntry{Role::map, "map", std::nullopt},
    RoleEntry{Role::linkage, "linkage", std::nullopt},
    RoleEntry{Role::joint, "joint", std::nullopt},
    RoleEntry{Role::reach, "reach", std::nullopt},
    RoleEntry{Role::sentence, "sentence", std::nullopt},
    RoleEntry{Role::number, "number", std::nullopt},
    RoleEntry{Role::button, "button", std::nullopt},
    RoleEntry{Role::hint, "hint", std::nullopt},
};

constexpr bool is_in_order(const auto& catalog) {
  for (std::size_t i = 0; i < catalog.size(); ++i) {
    if (static_cast<std::size_t>(catalog[i].id) != i) return false;
  }
  return true;
}
static_assert(is_in_order(entries) && is_in_order(roles) && roles.back().id == Role::hint);

}  // namespace

std::span<const GlossaryEntry> glossary() noexcept {
  return entries;
}

const GlossaryEntry& glossary(Term term) noexcept {
  return entries[static_cast<std::size_t>(term)];
}

std::optional<Term> term_of(Role role) noexcept {
  return roles[static_cast<std::size_t>(role)].term;
}

std::string_view role_name(Role role) noexcept {
  return roles[static_cast<std::size_t>(role)].name;
}

namespace {

constexpr std::array<Quantity, quantity_count> quantities{{
    {"force", "N", "force_N", Term::force, [](const StrategySnapshot<2>& now) { return glm::length(now.force); }, 2},
    {"ghost force", "N", "ghost_force_N", Term::ghost_force,
     [](const StrategySnapshot<2>& now) { return glm::length(now.ghost_force); }, 2, true},
    {"drift", "mm", "proxy_drift_mm", Term::proxy_drift,
     [](const StrategySnapshot<2>& now) { return glm::length(now.proxy_drift) * mm_per_m; }, 1, true},
    {"energy", "mJ", "energy_mJ", Term::energy, [](const StrategySnapshot<2>& now) { return now.energy * 1000.0; }, 1},
}};

}  // namespace

bool is_known(const Quantity& quantity, const Snapshot& snapshot, StrategyId id) noexcept {
  if (!quantity.is_against_goal || !snapshot.measured) return true;
  return snapshot.has_target && snapshot.measured == id &&
         !std::isnan(quantity.value(snapshot.strategies[index_of(id)]));
}

const std::array<Quantity, quantity_count>& quantity_catalog() noexcept {
  return quantities;
}

}  // namespace ghostforce
