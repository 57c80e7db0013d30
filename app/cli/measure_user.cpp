// ghostforce measure-user: how stiff the hand of a run was, from the proxy drift wherever it came to rest at the wall,
// and from the tones that measured it while it worked.
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/files/run_reader.h"
#include "app/runs/live_readings.h"
#include "core/conventions.h"
#include "core/divergence.h"
#include "core/user_measurement.h"

namespace ghostforce {
namespace {

// What counts as rest: within `reach` for at least `hold_s`. A hand that is held trembles.
struct RestCriterion {
  double reach;   // [m]
  double hold_s;  // [s]
};
constexpr RestCriterion simulated_rest{0.00002, 0.25};
constexpr RestCriterion measured_rest{0.0015, 0.5};

// By so much may differ what was sent from what was asked for [N]: far more than rounding, far less than is felt.
constexpr double same_force = 1e-6;

struct MeasureUserOptions {
  std::string run;
  std::optional<std::string> target_mm;
  bool json = false;
};

// One stretch of rest of one strategy's device.
struct Rest {
  StrategyId strategy;
  double from_s;
  double to_s;
  double tracking_ratio;            // ρ in use
  double force;                     // along the motors [N]
  std::optional<double> given_k_u;  // of a simulated hand [N/m]
  UserReading reading;
};

// The readings of one hand [N/m].
struct Hand {
  std::optional<double> given_k_u;
  std::vector<double> readings;
};

class RestFinder {
 public:
  RestFinder(const Run& run, const Strategy& strategy, const std::optional<Vector<2>>& target)
      : run_(run), strategy_(strategy), target_(target), criterion_(target ? measured_rest : simulated_rest) {
    for (const Settings& settings : run.settings) bases_.push_back(basis_of(settings));
  }

  std::vector<Rest> find() {
    RestWatch<2> device(criterion_.reach);
    RestWatch<2> goal(criterion_.reach);
    std::size_t first = 0;
    for (std::size_t i = 0; i < run_.ticks.size(); ++i) {
      if (i % std::size_t{ticks_between_looks} == 0) stop_if_interrupted();
      const bool goes_on = i > first && follows(i);
      if (goes_on) {
        see(i, device, goal);
        if (device.held_s() > 0.0 && goal.held_s() > 0.0) continue;
      }
      end_stretch(first, i);
      first = i;
      device.forget();
      goal.forget();
      if (counts(i)) see(i, device, goal);
    }
    end_stretch(first, run_.ticks.size());
    return std::move(rests_);
  }

 private:
  // Of what can be read: a target is there where the device was measured, and then only what was measured counts.
  bool counts(std::size_t i) const {
    const RunTick& tick = run_.ticks[i];
    if (!tick.rows[index_of(strategy_.id)]) return false;
    return target_ ? tick.measured == strategy_.id : !tick.measured;
  }
  bool follows(std::size_t i) const {
    const RunTick& tick = run_.ticks[i];
    const RunTick& before = run_.ticks[i - 1];
    return counts(i) && counts(i - 1) && bases_[tick.settings] == bases_[before.settings] &&
           given_k_u(i) == given_k_u(i - 1) && tick.state == RunTick::none;
  }
  // Of the simulated hand [N/m]; of a measured one nobody knows it.
  std::optional<double> given_k_u(std::size_t i) const {
    if (target_) return std::nullopt;
    const RunTick& tick = run_.ticks[i];
    return user_stiffness_at(*run_.scene, run_.settings[tick.settings], tick.time_s);
  }
  // All that a reading depends on: of what is believed or chosen, the ratio that this strategy makes of it.
  Settings basis_of(Settings settings) const {
    settings.active = strategy_.id;
    settings.stiffnesses.chosen_tracking_ratio = strategy_.tracking_ratio(settings.stiffnesses);
    settings.stiffnesses.believed_k_u.reset();
    if (target_) settings.stiffnesses.k_u = 1.0;  // of the simulated hands, which are not looked at
    return settings;
  }
  const RunRow& row(std::size_t i) const { return *run_.ticks[i].rows[index_of(strategy_.id)]; }
  Vector<2> aim(std::size_t i) const { return target_.value_or(run_.ticks[i].goal); }

  void see(std::size_t i, RestWatch<2>& device, RestWatch<2>& goal) const {
    device.see(run_.ticks[i].time_s, row(i).device);
    goal.see(run_.ticks[i].time_s, aim(i));
  }

  // Of the ticks from `first` up to `end`: the mean over the second half, when the device has come nearest to rest.
  void end_stretch(std::size_t first, std::size_t end) {
    if (end == first || !counts(first)) return;
    const double from_s = run_.ticks[first].time_s;
    const double to_s = run_.ticks[end - 1].time_s;
    if (to_s - from_s < criterion_.hold_s) return;
    const Settings& settings = run_.settings[run_.ticks[first].settings];
    RestState<2> mean;
    mean.tracking_ratio = strategy_.tracking_ratio(settings.stiffnesses);
    const std::size_t middle = first + (end - first) / 2;
    const double share = 1.0 / static_cast<double>(end - middle);
    for (std::size_t i = middle; i < end; ++i) {
      mean.aim += share * aim(i);
      mean.device += share * row(i).device;
      mean.proxy += share * row(i).proxy;
      mean.force += share * row(i).force;
    }
    UserReading reading = read_user(wall_of(settings), actuation_of(settings), mean);
    const bool would_count = reading.problem == NoReading::none || reading.problem == NoReading::no_such_hand;
    if (would_count && is_limited(middle, end)) reading = {.problem = NoReading::limited, .drift = reading.drift};
    rests_.push_back({strategy_.id, from_s, to_s, mean.tracking_ratio,
                      glm::dot(mean.force, direction_at(settings.actuated_angle)), given_k_u(first), reading});
  }

  // Whether the motors of a real device had something else than the rendering and the tones asked for. A handle whose
  // way is shown enlarged has a share of the force that is the same throughout; ramps, limits and fades have none.
  bool is_limited(std::size_t begin, std::size_t end) const {
    double asked = 0.0;
    double sent = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      if (row(i).is_saturated) return true;
      if (!row(i).sent) return false;  // simulated, or not told
      asked += glm::dot(row(i).force, row(i).force);
      sent += glm::dot(*row(i).sent - row(i).tone, row(i).force);
    }
    if (!(asked > 0.0)) return false;
    const double share = sent / asked;
    if (!(share > 0.0)) return true;
    const auto is_share = [&](std::size_t i) {
      return glm::distance(*row(i).sent - row(i).tone, share * row(i).force) <= same_force;
    };
    return !std::ranges::all_of(std::views::iota(begin, end), is_share);
  }

  const Run& run_;
  const Strategy& strategy_;
  std::optional<Vector<2>> target_;
  RestCriterion criterion_;
  std::vector<Settings> bases_;  // of run_.settings
  std::vector<Rest> rests_;
};

// In the order of time; at rest in free space there is nothing to say.
std::vector<Rest> find_rests(const Run& run, const std::optional<Vector<2>>& target) {
  std::vector<Rest> rests;
  for (const Strategy& strategy : strategy_catalog()) {
    if (strategy.has_every_motor) continue;  // it has no ratio, and no drift
    std::ranges::move(RestFinder(run, strategy, target).find(), std::back_inserter(rests));
  }
  std::erase_if(rests, [](const Rest& rest) { return rest.reading.problem == NoReading::no_contact; });
  std::ranges::stable_sort(rests, {}, &Rest::from_s);
  return rests;
}

// In the order in which they came. Without a reading there is none.
std::vector<Hand> hands_of(const std::vector<Rest>& rests) {
  std::vector<Hand> hands;
  for (const Rest& rest : rests) {
    if (rest.reading.problem != NoReading::none) continue;
    auto hand = std::ranges::find(hands, rest.given_k_u, &Hand::given_k_u);
    if (hand == hands.end()) hand = hands.insert(hands.end(), Hand{rest.given_k_u, {}});
    hand->readings.push_back(rest.reading.k_u);
  }
  return hands;
}

// What cannot be known is null.
nlohmann::ordered_json json_of(const LiveReading& reading) {
  const HandEstimate& hand = reading.estimate;
  nlohmann::ordered_json entry{{"t_s", reading.time_s}};
  const auto add = [&](const char* name, double number) {
    entry[name] = hand.has_number() ? nlohmann::ordered_json(number) : nullptr;
  };
  add("k_u_N_per_m", hand.k_u);
  add("sigma_N_per_m", hand.sigma);
  add("mass_kg", hand.mass);
  add("damping_N_s_per_m", hand.damping);
  entry["known"] = hand.is_known();
  entry["reason"] = sentence_of(hand.why);
  return entry;
}

std::string json_text(const std::vector<Rest>& rests, const std::vector<Hand>& hands,
                      const std::vector<LiveReading>& live, bool measured) {
  nlohmann::ordered_json json;
  json["device_kind"] = measured ? "measured" : "simulated";
  json["readings"] = nlohmann::ordered_json::array();
  for (const Rest& rest : rests) {
    nlohmann::ordered_json entry{
        {"strategy", strategy(rest.strategy).name}, {"from_s", rest.from_s},         {"to_s", rest.to_s},
        {"tracking_ratio", rest.tracking_ratio},    {"drift_m", rest.reading.drift}, {"force_N", rest.force}};
    if (rest.reading.problem == NoReading::none) {
      entry["null_ratio"] = rest.reading.null_ratio;
      entry["k_u_N_per_m"] = rest.reading.k_u;
    } else {
      entry["why_not"] = sentence_of(rest.reading.problem);
    }
    if (rest.given_k_u) entry["given_k_u_N_per_m"] = *rest.given_k_u;
    json["readings"].push_back(std::move(entry));
  }
  json["hands"] = nlohmann::ordered_json::array();
  for (const Hand& hand : hands) {
    nlohmann::ordered_json entry;
    if (hand.given_k_u) entry["given_k_u_N_per_m"] = *hand.given_k_u;
    const Spread spread = spread_of(hand.readings);
    entry["count"] = hand.readings.size();
    entry["k_u_N_per_m"] = {{"median", spread.median},
                            {"lower_quartile", spread.lower_quartile},
                            {"upper_quartile", spread.upper_quartile}};
    json["hands"].push_back(std::move(entry));
  }
  json["live"] = nlohmann::ordered_json::array();
  for (const LiveReading& reading : live) json["live"].push_back(json_of(reading));
  return json.dump() + "\n";
}

bool is_known(const LiveReading& reading) {
  return reading.estimate.is_known();
}

// Of those for which the hand is unknown.
HandUnknown commonest_reason(const std::vector<LiveReading>& live) {
  std::array<std::size_t, hand_unknown_count> counts{};
  for (const LiveReading& reading : live) ++counts[static_cast<std::size_t>(reading.estimate.why)];
  counts[static_cast<std::size_t>(HandUnknown::none)] = 0;
  return static_cast<HandUnknown>(std::ranges::max_element(counts) - counts.begin());
}

// A line for each window that has nothing in common with the one before; all of them count in the summary.
std::string live_text(const std::vector<LiveReading>& live) {
  std::string text = fmt::format("{:>8} {:>10} {:>8} {:>8} {:>10}\n{:>8} {:>10} {:>8} {:>8} {:>10}\n", "window", "k_u",
                                 "± σ", "m", "b", "ends s", "N/m", "N/m", "kg", "N·s/m");
  std::vector<double> known;
  double shown_s = -HandEstimator::usual_window_s;
  for (const auto& [time_s, hand] : live | std::views::filter(is_known)) {
    known.push_back(hand.k_u);
    const bool overlaps = time_s >= shown_s && time_s - shown_s < HandEstimator::usual_window_s;
    if (overlaps) continue;
    shown_s = time_s;
    text += fmt::format("{:8.3f} {:10.2f} {:8.2f} {:8.3f} {:10.2f}\n", time_s, hand.k_u, hand.sigma, hand.mass,
                        hand.damping);
  }
  const Spread spread = spread_of(known);
  return text +
         fmt::format(
             "\nmeasured live, at 3 Hz along the motor: median {:.2f} N/m, the middle half from {:.2f} to {:.2f} "
             "N/m; known in {} of {} windows\n",
             spread.median, spread.lower_quartile, spread.upper_quartile, known.size(), live.size());
}

std::string table_text(const std::vector<Rest>& rests, const std::vector<Hand>& hands, bool measured) {
  const std::string_view given_head = measured ? "" : "     given";
  const std::string_view given_unit = measured ? "" : "       N/m";
  std::string text = fmt::format(
      "{:12} {:>8} {:>8} {:>8} {:>9} {:>9}{} {:>8} {:>10}\n{:12} {:>8} {:>8} {:>8} {:>9} {:>9}{} "
      "{:>8} {:>10}\n",
      "strategy", "from", "to", "ρ", "drift", "force", given_head, "ρ°", "k_u", "", "s", "s", "", "mm", "N", given_unit,
      "", "N/m");
  for (const Rest& rest : rests) {
    text += fmt::format("{:12} {:8.3f} {:8.3f} {:8.3f} {:9.3f} {:9.3f}", strategy(rest.strategy).name, rest.from_s,
                        rest.to_s, rest.tracking_ratio, mm_per_m * rest.reading.drift, rest.force);
    if (rest.given_k_u) text += fmt::format("{:10.2f}", *rest.given_k_u);
    text += rest.reading.problem == NoReading::none
                ? fmt::format(" {:8.3f} {:10.2f}\n", rest.reading.null_ratio, rest.reading.k_u)
                : fmt::format(" {}\n", sentence_of(rest.reading.problem));
  }
  for (const Hand& hand : hands) {
    const Spread spread = spread_of(hand.readings);
    const std::size_t count = hand.readings.size();
    text +=
        fmt::format("\nmeasured k_u: median {:.2f} N/m of {} reading{}, the middle half from {:.2f} to {:.2f} N/m\n",
                    spread.median, count, count == 1 ? "" : "s", spread.lower_quartile, spread.upper_quartile);
    if (hand.given_k_u) text += fmt::format("given to the simulated hand: {:.2f} N/m\n", *hand.given_k_u);
  }
  return text;
}

void refuse_unstable_run(const Run& run, const std::string& path) {
  for (const RunTick& tick : run.ticks) {
    for (const Strategy& each : strategy_catalog()) {
      const std::optional<RunRow>& row = tick.rows[index_of(each.id)];
      if (row && !(is_near(row->device) && is_near(row->proxy))) throw unstable_loop(each.id, tick.time_s, path);
    }
  }
}

int measure_user(const MeasureUserOptions& options) {
  std::optional<Vector<2>> target;
  if (options.target_mm) target = position_from_mm("--target-mm", *options.target_mm);
  const Run run = load_run(options.run);
  for (const std::string& warning : run.warnings) say("{}\n", warning);
  if (!run.scene) {
    throw Failure(ExitCode::wrong_call, fmt::format("{}: contains no scene, so wall and motor are not known; give a "
                                                    "file from 'simulate', 'replay' or a recording",
                                                    quoted_text(options.run, longest_path)));
  }
  if (is_general(run.scene->settings)) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{}: is a run of a scene of format 2, whose wall and motor do not tell the user's "
                              "stiffness as those of format 1 do; give a run of such a scene",
                              quoted_text(options.run, longest_path)));
  }
  refuse_unstable_run(run, options.run);
  const bool measured = std::ranges::any_of(run.ticks, [](const RunTick& tick) { return tick.measured.has_value(); });
  const auto was_not_told = [](const RunTick& tick) {
    return tick.measured && tick.rows[index_of(*tick.measured)] && !tick.rows[index_of(*tick.measured)]->sent;
  };
  const std::vector<LiveReading> live = live_readings(run);
  const bool is_known_live = std::ranges::any_of(live, is_known);
  const bool was_measured_by_tones = has_tones(run);
  if (was_measured_by_tones && std::ranges::any_of(run.ticks, was_not_told)) {
    say("{}: what the motors of its device gave is not told, and without it tones tell no hand; that takes the columns "
        "device_kind, sent_x_N and sent_y_N\n",
        quoted_text(options.run, longest_path));
  }
  if (measured && !target && !was_measured_by_tones) {
    if (options.json) print(json_text({}, {}, live, measured));
    throw Failure(ExitCode::wrong_call, fmt::format("{}: nobody knows the goal of a hand on a real device; give the "
                                                    "target on the wall that it aimed at, as in --target-mm=0,0",
                                                    quoted_text(options.run, longest_path)));
  }
  if (!measured && target) {
    say("{}: the goal of its hand is given, so --target-mm, which is for a real device, is not used\n",
        quoted_text(options.run, longest_path));
  }
  // Tones need no target, and without one there is no other reading.
  const bool reads_rests = !measured || target;
  const std::vector<Rest> rests = reads_rests ? find_rests(run, measured ? target : std::nullopt) : std::vector<Rest>();
  const std::vector<Hand> hands = hands_of(rests);
  if (options.json) {
    print(json_text(rests, hands, live, measured));
  } else {
    if (!hands.empty()) print(table_text(rests, hands, measured));
    if (!hands.empty() && is_known_live) print("\n");
    if (is_known_live) print(live_text(live));
  }
  if (!hands.empty() || is_known_live) return static_cast<int>(ExitCode::done);
  if (was_measured_by_tones) {
    throw Failure(ExitCode::answer_is_no, fmt::format("{}: no reading. {}", quoted_text(options.run, longest_path),
                                                      sentence_of(commonest_reason(live))));
  }
  throw Failure(
      ExitCode::answer_is_no,
      fmt::format(
          "{}: no reading. The hand has to press into the wall with the naïve or the anisotropic strategy and "
          "hold still for at least {} s{}",
          quoted_text(options.run, longest_path), (measured ? measured_rest : simulated_rest).hold_s,
          rests.empty() ? "" : fmt::format("; where it did so: {}", sentence_of(rests.front().reading.problem))));
}

}  // namespace

std::function<int()> attach_measure_user(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<MeasureUserOptions>();
  files.reads(
      add_option(command, "RUN.csv", options->run, "A CSV file from 'simulate', 'replay' or a recording")->required());
  add_option(command, "--target-mm X,Y", options->target_mm,
             "Where the hand aimed, in mm; the nearest point of the wall counts. Needed for a real device "
             "unless tones measured the hand; ignored for a simulated one");
  command.add_flag("--json", options->json, "Print JSON for programs, in SI units with all digits");
  return [options] { return measure_user(*options); };
}

}  // namespace ghostforce
