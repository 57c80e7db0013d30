// fault_table: what the program does about each fault while the motors push, how soon, and how it comes back; measured
// where the cable ends, printed as a Markdown table. docs/falcon.md shows one. Start it through umockdev-wrapper:
//   umockdev-wrapper build/release/bin/fault_table --runs 20 -o -
//   umockdev-wrapper build/release/bin/fault_table --runs 20 --load 8 --only Kill,Stopped -o -
// Exit codes: 0 every promise was kept, 1 one was broken, 2 wrong call.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "tests/emulation/fault_trial.h"

namespace ghostforce {
namespace {

constexpr std::chrono::milliseconds patience{4'000};
// Where the machine came later than this to look, a promise's time says nothing of the program: once more.
constexpr std::int64_t latest_look_ns = 4'000'000;
constexpr int trials_per_run = 10;
constexpr std::int64_t soon_ns = 25'000'000;

struct Row {
  const Fault* fault = nullptr;
  std::vector<FaultOutcome> outcomes;
  int repeated = 0;
  std::map<std::string, int> broken;  // promises, and how often each was
  std::string unmeasured;             // why; empty: all runs were
};

// As a machine would have seen it that came to look in time.
FaultOutcome without_lateness(FaultOutcome outcome) {
  for (std::optional<std::int64_t>* const time_ns :
       {&outcome.zero_ns, &outcome.zero_try_ns, &outcome.plug_to_zero_ns}) {
    if (*time_ns) **time_ns -= 2 * outcome.late_ns;
  }
  outcome.longest_hold_ns -= 2 * outcome.late_ns;
  outcome.longest_false_off_ns -= 2 * outcome.late_ns;
  return outcome;
}

Row measure(TestBed& bed, const Fault& fault, int runs, int load) {
  Row row;
  row.fault = &fault;
  row.unmeasured = hold_obstacle(fault.hold);
  for (int run = 0; run < runs && row.unmeasured.empty(); ++run) {
    FaultOutcome outcome;
    for (int trial = 1; trial <= trials_per_run && row.unmeasured.empty(); ++trial) {
      try {
        outcome = try_fault(bed, fault, patience, load);
      } catch (const std::runtime_error& error) {
        row.unmeasured = error.what();
      }
      const bool is_only_late = !broken_promise(fault, outcome, true).empty() &&
                                broken_promise(fault, without_lateness(outcome), true).empty();
      if (!is_only_late || outcome.late_ns < latest_look_ns) break;
      ++row.repeated;
    }
    if (!row.unmeasured.empty()) break;
    if (const std::string broken = broken_promise(fault, outcome, true); !broken.empty()) ++row.broken[broken];
    row.outcomes.push_back(outcome);
  }
  return row;
}

// The median and the worst.
std::string times(const std::vector<std::int64_t>& values_ns) {
  std::vector<std::int64_t> sorted = values_ns;
  std::ranges::sort(sorted);
  const auto in_ms = [](std::int64_t ns) { return static_cast<double>(std::max<std::int64_t>(ns, 0)) * 1e-6; };
  return fmt::format("{:.1f} / {:.1f} ms", in_ms(sorted[sorted.size() / 2]), in_ms(sorted.back()));
}

// It was got over for a while, and then no more: what counts is how long a force was held at most.
bool ended_later(const Fault& fault, const FaultOutcome& outcome) {
  return fault.promise == Promise::zero_or_onward && *outcome.zero_ns > soon_ns;
}

// What is said besides, of a part of the outcomes.
void add_part(std::string& text, const std::string& part) {
  text += (text.empty() ? "" : "; ") + part;
}

std::string time_to_fast(const Row& row) {
  std::vector<std::int64_t> values;
  for (const FaultOutcome& outcome : row.outcomes) {
    if (outcome.fast_ns) values.push_back(*outcome.fast_ns);
  }
  std::string text;
  if (!values.empty()) add_part(text, "no force; fast enough after " + times(values));
  if (const std::size_t slow = row.outcomes.size() - values.size(); slow > 0) {
    add_part(text, fmt::format("no force; {} of {}: it stays too slow", slow, row.outcomes.size()));
  }
  return text;
}

// What else a force did.
void add_remarks(std::string& text, const Row& row) {
  std::vector<std::int64_t> plugged_in;
  std::vector<std::int64_t> false_offs;
  std::size_t came_back = 0;
  std::uint64_t most = 0;
  std::size_t slow = 0;
  std::size_t out_of_turn = 0;
  for (const FaultOutcome& outcome : row.outcomes) {
    if (outcome.plug_to_zero_ns) plugged_in.push_back(*outcome.plug_to_zero_ns);
    if (outcome.longest_false_off_ns > soon_ns) false_offs.push_back(outcome.longest_false_off_ns);
    if (outcome.forces_after_hold > 0) ++came_back;
    most = std::max(most, outcome.forces_after_hold);
    if (outcome.stays_slow) ++slow;
    if (outcome.other_was_taken_first) ++out_of_turn;
  }
  const auto of_all = [&](std::size_t count) { return fmt::format("{} of {}: ", count, row.outcomes.size()); };
  if (!plugged_in.empty()) add_part(text, "plugged in again: zero after " + times(plugged_in));
  if (came_back > 0) {
    add_part(text, of_all(came_back) + fmt::format("the force came back when it could run again, {} commands", most));
  }
  if (!false_offs.empty()) {
    add_part(text, of_all(false_offs.size()) + "it said \"off\" while they pushed, for " + times(false_offs));
  }
  if (slow > 0) add_part(text, of_all(slow) + "stays too slow");
  if (out_of_turn > 0) add_part(text, of_all(out_of_turn) + "the other one was taken first");
}

std::string time_to_zero(const Row& row) {
  if (row.fault->promise == Promise::fast) return time_to_fast(row);
  std::vector<std::int64_t> zeros;
  std::vector<std::int64_t> tries;
  std::vector<std::int64_t> holds;
  std::vector<std::int64_t> last_holds;
  std::size_t stayed = 0;
  std::size_t untried = 0;
  for (const FaultOutcome& outcome : row.outcomes) {
    if (outcome.went_on) {
      holds.push_back(outcome.longest_hold_ns);
    } else if (row.fault->promise == Promise::last_try) {
      if (outcome.zero_try_ns) {
        tries.push_back(*outcome.zero_try_ns);
      } else {
        ++untried;
      }
    } else if (outcome.zero_ns && ended_later(*row.fault, outcome)) {
      last_holds.push_back(outcome.longest_hold_ns);
    } else if (outcome.zero_ns) {
      zeros.push_back(*outcome.zero_ns);
    }
    if (!outcome.went_on && !outcome.zero_ns) ++stayed;
  }
  std::string text;
  const auto add = [&](const std::string& part) { add_part(text, part); };
  if (!zeros.empty()) add(times(zeros));
  if (!last_holds.empty()) add("armed for a while; no force older than " + times(last_holds));
  if (!tries.empty()) add("wire dead: a zero was tried last, after " + times(tries));
  if (!holds.empty()) add("stays armed; no force older than " + times(holds));
  if (untried > 0) add(fmt::format("{} of {}: wire dead, and a force was tried last", untried, row.outcomes.size()));
  if (stayed > 0) add(fmt::format("{} of {}: the force stayed", stayed, row.outcomes.size()));
  add_remarks(text, row);
  return text.empty() ? "-" : text;
}

std::string what_it_says(const Row& row) {
  std::map<std::string, int> said;
  for (const FaultOutcome& outcome : row.outcomes) {
    if (outcome.went_on) continue;
    ++said[outcome.exit_code ? fmt::format("ends with {}", *outcome.exit_code) : outcome.words()];
  }
  std::string text;
  for (const auto& [words, count] : said) text += (text.empty() ? "" : " / ") + words;
  return text.empty() ? "nothing" : text;
}

std::string how_it_comes_back(const Row& row) {
  if (row.fault->program_hangs) return "end the program by force, and start it again";
  std::vector<std::int64_t> backs;
  std::size_t ended = 0;
  std::size_t onward = 0;
  for (const FaultOutcome& outcome : row.outcomes) {
    if (outcome.exit_code) {
      ++ended;
    } else if (outcome.went_on) {
      ++onward;
    } else if (outcome.came_back) {
      backs.push_back(outcome.back_ns);
    }
  }
  if (ended == row.outcomes.size()) return "start the program again";
  std::string text;
  if (!backs.empty()) {
    std::ranges::sort(backs);
    const double worst_s = static_cast<double>(backs.back()) * 1e-9;
    text = "by itself, motors off, " + (worst_s < 0.1 ? "at once" : fmt::format("within {:.1f} s", worst_s));
  }
  if (onward > 0) text += text.empty() ? "it was never away" : " (or was never away)";
  const std::size_t lost = row.outcomes.size() - ended - onward - backs.size();
  if (lost > 0) text += fmt::format("{}{} of {}: not by itself", text.empty() ? "" : "; ", lost, row.outcomes.size());
  return text;
}

std::string line_of(const Row& row) {
  if (row.outcomes.empty()) return fmt::format("| {} | - | not measured: {} | - |", row.fault->title, row.unmeasured);
  return fmt::format("| {} | {} | {} | {} |", row.fault->title, what_it_says(row), time_to_zero(row),
                     how_it_comes_back(row));
}

int run(int runs, bool quick, int load, const std::vector<std::string>& only, const std::string& to) {
  for (const std::string& name : only) {
    if (std::ranges::find(fault_catalog(), name, &Fault::name) != fault_catalog().end()) continue;
    fmt::print(stderr, "fault_table: no fault is named '{}'; see tests/emulation/fault_catalog.cpp.\n", name);
    return 2;
  }
  TestBed bed;
  std::string table =
      "| Fault | What the program says | To zero, median / worst | How it comes back |\n|---|---|---|---|\n";
  int broken = 0;
  for (const Fault& fault : fault_catalog()) {
    if ((quick && !fault.is_quick) || (!only.empty() && std::ranges::find(only, fault.name) == only.end())) continue;
    const Row row = measure(bed, fault, runs, load);
    table += line_of(row) + "\n";
    fmt::print(stderr, "{}\n", line_of(row));
    if (row.repeated > 0) fmt::print(stderr, "  {} trials repeated: the machine was late\n", row.repeated);
    if (!row.unmeasured.empty()) fmt::print(stderr, "  not measured to the end: {}\n", row.unmeasured);
    for (const auto& [promise, count] : row.broken) fmt::print(stderr, "  BROKEN, {} times: {}\n", count, promise);
    broken += row.broken.empty() ? 0 : 1;
  }
  if (to == "-") {
    std::cout << table << std::flush;
  } else {
    std::ofstream file(to);
    if (!(file << table << std::flush)) throw std::runtime_error(to + " cannot be written");
  }
  if (broken > 0) fmt::print(stderr, "{} promises were broken.\n", broken);
  return broken > 0 ? 1 : 0;
}

}  // namespace
}  // namespace ghostforce

int main(int argc, char** argv) {
  CLI::App app{"Measures what the program does about each fault of a Falcon while its motors push."};
  int runs = 20;
  bool quick = false;
  int load = 0;
  std::vector<std::string> only;
  std::string to = "-";
  app.add_option("--runs", runs, "trials of each fault")->check(CLI::Range(1, 1000));
  app.add_flag("--quick", quick, "one trial each of a representative half");
  app.add_option("--only", only, "these faults, by name, separated by commas")->delimiter(',');
  app.add_option("--load", load, "so many busy processes run beside the program while it pushes")
      ->check(CLI::Range(0, 64));
  app.add_option("-o", to, "the table goes to this file; -: standard output");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return ghostforce::run(quick ? 1 : runs, quick, load, only, to);
  } catch (const std::exception& error) {
    fmt::print(stderr, "fault_table: {}\n", error.what());
    return 2;
  }
}
