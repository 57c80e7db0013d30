#include "app/files/csv_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <locale>

namespace ghostforce::csv_table_test {
namespace {

TEST(CsvTable, HasCommentsNamesAndRows) {
  const CsvTable table{
      {"where it comes from", "two\nlines"}, {"name", "x_m"}, {{std::string("a"), 0.1}, {std::string("b"), -2.0}}};
  EXPECT_EQ(csv_text(table), "# where it comes from\n# two lines\nname,x_m\na,0.1\nb,-2\n");
}

TEST(CsvTable, QuotesWhatWouldBeTakenForSomethingElse) {
  const CsvTable table{{},
                       {"a", "b"},
                       {{std::string("#1"), std::string("x, y")},
                        {std::string("say \"no\""), std::string(" ")},
                        {std::string("1\r\n2"), std::string("#")},
                        {std::string(" before"), std::string("behind ")}}};
  EXPECT_EQ(csv_text(table), "a,b\n\"#1\",\"x, y\"\n\"say \"\"no\"\"\",\" \"\n1  2,#\n\" before\",\"behind \"\n");
}

TEST(CsvTable, HasNumbersInTheShortestFormThatReadsBackWhateverTheLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const CsvTable table{
      {},
      {"x"},
      {{0.1 + 0.2}, {1e-9}, {std::numeric_limits<double>::quiet_NaN()}, {std::numeric_limits<double>::infinity()}}};
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const std::string text = csv_text(table);
  std::locale::global(before);
  EXPECT_EQ(text, "x\n0.30000000000000004\n1e-09\nnan\ninf\n");
}

}  // namespace
}  // namespace ghostforce::csv_table_test
