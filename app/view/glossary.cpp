#include "app/view/glossary.h"

#include <array>

namespace ghostforce {
namespace {

constexpr std::array entries{
    GlossaryEntry{Term::goal, "Goal q_u", "Where your hand wants the device to be; drag it.", "", "mm"},
    GlossaryEntry{Term::device, "Device q_h",
                  "Where the device is: the hand pulls it to the goal, its motors push back.",
                  "k_u (q_u − q_h) + f_r = 0 at rest", "mm"},
    GlossaryEntry{
        Term::proxy, "Proxy q_p",
        "Where the handle should be: the wall holds this point back, and the motors pull the device towards it.",
        "K_t (q_h − q_p) + k_c (q_c − q_p) = 0", "mm"},
    GlossaryEntry{Term::contact, "Contact q_c", "The point of the wall that is nearest to the proxy.",
                  "q_c = q_p + n (n·(o − q_p))", "mm"},
    GlossaryEntry{Term::wall, "Virtual wall",
                  "The device may be on the side without hatching; turn the wall by the round grips at its ends.",
                  "n·(q − o) ≥ 0", ""},
    GlossaryEntry{Term::force, "Rendered force f_r", "How hard the device pushes on the hand.", "f_r = K_r (q_p − q_h)",
                  "N"},
    GlossaryEntry{Term::ghost_force, "Ghost force",
                  "What the device pushes along its motor beyond what a fully actuated one would; it should be zero.",
                  "P_A (f_r − f_r of F)", "N"},
    GlossaryEntry{Term::proxy_drift, "Proxy drift",
                  "How far the proxy has slid along the wall, away from where the hand aims; it should be zero.",
                  "(q_p − q_u) along the wall", "mm"},
    GlossaryEntry{Term::energy, "Energy",
                  "What the rendering has given to the hand since the reset: round a closed loop it should be none. "
                  "Above zero it was active, not passive.",
                  "Σ f_r,k−1 · (q_h,k − q_h,k−1)", "mJ"},
    GlossaryEntry{Term::model_error, "Model − simulation",
                  "How far the simulated devices still are from where the closed forms put them at rest.",
                  "max |q_h − q_h of the paper's (9) to (20)|", "mm"},
    GlossaryEntry{Term::prediction, "Prediction",
                  "Where the closed form puts device and proxy at rest; the simulation comes to the rings by itself.",
                  "equations (9) to (20) of the paper", "mm"},
    GlossaryEntry{Term::trail, "Trail", "Where the goal (dots) and the devices have been.", "", "mm"},
    GlossaryEntry{Term::hand_spring, "Hand", "The spring by which the hand pulls the device to its goal.",
                  "f_u = k_u (q_u − q_h)", "N"},
    GlossaryEntry{Term::tracking_link, "Tracking", "The spring by which the proxy follows the device.",
                  "f_t = K_t (q_h − q_p)", "N"},
    GlossaryEntry{Term::motor_axis, "Motor axis",
                  "The direction in which the device can push; drag its arrow to turn it. Across it there is no motor.",
                  "counter-clockwise from x", "°"},
    GlossaryEntry{Term::wall_normal, "Wall normal n", "The direction in which the wall faces.",
                  "counter-clockwise from x", "°"},
    GlossaryEntry{Term::rendering_stiffness, "Rendering stiffness k_r",
                  "Of the spring that pushes the device towards the proxy, where there are motors.",
                  "f_r = K_r (q_p − q_h)", "N/m"},
    GlossaryEntry{Term::tracking_stiffness, "Tracking stiffness k_t",
                  "Of the spring by which the proxy follows the device, along the motors.", "f_t = K_t (q_h − q_p)",
                  "N/m"},
    GlossaryEntry{Term::constraint_stiffness, "Constraint stiffness k_c",
                  "Of the spring by which the wall holds the proxy back.", "f_c = k_c (q_c − q_p)", "N/m"},
    GlossaryEntry{Term::hard_constraint, "Hard constraint", "The proxy never enters the wall.", "k_c = ∞", ""},
    GlossaryEntry{
        Term::tracking_ratio, "Tracking ratio ρ",
        "How much stiffer the proxy follows along the motors than across them: 1 is naïve, ρ* takes the ghost "
        "force away. Used by anisotropic rendering.",
        "ρ = k_ta / k_tn,  ρ* = 1 + k_r / k_u", ""},
    GlossaryEntry{Term::user_stiffness, "User stiffness k_u", "How stiffly the hand holds on to its goal.",
                  "f_u = k_u (q_u − q_h)", "N/m"},
    GlossaryEntry{Term::believed_user_stiffness, "Believed user stiffness",
                  "The k_u that the renderer puts into ρ*; it cannot measure it, and a wrong one brings drift back.",
                  "ρ* = 1 + k_r / believed k_u", "N/m"},
    GlossaryEntry{Term::right_belief, "Same", "The renderer happens to know the hand's true stiffness.",
                  "believed k_u = k_u", ""},
    GlossaryEntry{Term::force_scale, "Scale", "How long the arrows are for a force, and how long the picture is in mm.",
                  "", "N, mm"},
    GlossaryEntry{Term::target, "Target",
                  "Aim here: press straight into the wall. Ghost force and drift are then shown against the target.",
                  "", ""},
    GlossaryEntry{Term::drift_of_belief, "Drift of anisotropic",
                  "How far the anisotropic strategy still drifts along the wall: with the right belief, not at all.",
                  "(q_p − q_u) along the wall", "mm"},
    GlossaryEntry{Term::null_drift, "Drift to be nulled",
                  "How far the proxy has drifted along the wall from the goal. Above zero, ρ is too low.",
                  "(λ/k_t) (1 + k_r/k_u − ρ) √(α (1 − α)),  α = nᵀP_A n", "mm"},
    GlossaryEntry{Term::drift_from_target, "Drift to be nulled",
                  "How far the proxy has drifted along the wall from the target. Above zero, ρ is too low.",
                  "(λ/k_t) (1 + k_r/k_u − ρ) √(α (1 − α)),  α = nᵀP_A n", "mm"},
    GlossaryEntry{Term::null_ratio, "Ratio ρ° without drift",
                  "The ratio at which the drift vanishes. It is the optimal one, and tells k_u.",
                  "k_u = k_r / (ρ° − 1)", ""},
    GlossaryEntry{
        Term::loop_area, "Area of the loop",
        "What the device, not the goal, went round on a turn, counter-clockwise above zero; mean of all turns.",
        "S = ½ Σ q_h,k−1 × q_h,k", "mm²"},
    GlossaryEntry{
        Term::loop_energy, "Energy per turn",
        "What the rendering gave to the hand on the last turn, and in the mean. Above zero it was active. The "
        "sampled loop loses a little of it by its delay.",
        "Σ f_r,k−1 · (q_h,k − q_h,k−1)", "mJ"},
    GlossaryEntry{Term::loop_formula, "Energy by the formula",
                  "For a slow loop of the same area; θ is the angle from n to the motor. Fully actuated: none.",
                  "−k_r sinθ cosθ S / (cos²θ + ρ sin²θ + k_t/k_c)", "mJ"},
    GlossaryEntry{
        Term::estimated_goal, "Goal q_u, estimated",
        "Where the hand seems to want the device to be: nobody can measure it. It is inferred from the force, "
        "with the believed k_u.",
        "q_h − f_r / believed k_u", "mm"},
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

}  // namespace ghostforce
