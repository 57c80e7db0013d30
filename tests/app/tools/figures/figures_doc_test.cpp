// docs/figures.md names each figure, and its numbers are those of this program.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "app/tools/figures/figure.h"
#include "app/tools/figures/figures.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::figures_doc_test {
namespace {

std::string cell(double value) {
  return fmt::format(" {}{:.3f} |", value < 0.0 ? "−" : "", std::abs(value));
}

std::string numbers_table() {
  std::string table =
      "| pane | F device, mm | N | A | F force, N | N | A | ghost force of N, N |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  std::vector<SimulatedMotion> motions = directions_of_intent();
  std::ranges::move(stiffness_ratios(), std::back_inserter(motions));
  for (const SimulatedMotion& motion : motions) {
    table += "| " + motion.name + " |";
    for (const PredictedEquilibrium& rest : motion.rest) table += cell(1000.0 * rest.at.device.x);
    for (const PredictedEquilibrium& rest : motion.rest) table += cell(rest.at.force.x);
    table += cell(motion.rest[index_of(StrategyId::naive)].ghost_force.x) + "\n";
  }
  return table;
}

TEST(FiguresDoc, NamesEachFigureWithItsCommand) {
  const std::string doc = read_whole(source_path("/docs/figures.md"));
  for (const FigureEntry& entry : figure_catalog()) {
    EXPECT_NE(doc.find(fmt::format("| `{0}` | `ghostforce figures -o figures --only {0}` |", entry.name)),
              std::string::npos)
        << entry.name;
  }
}

TEST(FiguresDoc, HasTheNumbersOfThisProgram) {
  const std::string table = numbers_table();
  EXPECT_NE(read_whole(source_path("/docs/figures.md")).find(table), std::string::npos)
      << "docs/figures.md should hold\n"
      << table;
}

}  // namespace
}  // namespace ghostforce::figures_doc_test
