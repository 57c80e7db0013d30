// What is written so that groff shows it as it was meant.
#include "app/cli/manual.h"

#include <string>

#include <gtest/gtest.h>

namespace ghostforce::man_page_test {
namespace {

Manual manual_with_notes(const std::string& notes) {
  Manual manual;
  manual.version = "1.2.3";
  manual.program = {.name = "ghostforce", .sentence = "See forces"};
  manual.commands = {{.name = "render",
                      .sentence = "Draw a picture",
                      .notes = notes,
                      .examples = "  ghostforce x -o 'a'\n\n  ghostforce y"}};
  manual.exit_codes = {{"0", "done."}};
  return manual;
}

std::string page_with_notes(const std::string& notes) {
  const Manual manual = manual_with_notes(notes);
  return man_page(manual, manual.commands.front());
}

void expect_in(const std::string& page, const std::string& part) {
  EXPECT_NE(page.find(part), std::string::npos) << part << "\nis not in\n" << page;
}

TEST(RoffText, NothingIsACommandOrATypographicSign) {
  EXPECT_EQ(roff_text(R"(a\b -o 'x' "y" `z` ^ ~/f)"), R"(a\(rsb \-o \(aqx\(aq \(dqy\(dq \(gaz\(ga \(ha \(ti/f)");
}

TEST(RoffText, OtherLettersAreNamedByNumber) {
  EXPECT_EQ(roff_text("ρ° − 1 …"), R"(\[u03C1]\[u00B0] \[u2212] 1 \[u2026])");
}

TEST(ManPage, HasItsSectionsInTheUsualOrder) {
  const Manual manual = manual_with_notes("Notes.");
  std::size_t last = 0;
  const std::string page = man_page(manual, manual.commands.front());
  for (const char* title : {"NAME", "SYNOPSIS", "DESCRIPTION", "EXIT STATUS", "EXAMPLES", "SEE ALSO"}) {
    const std::size_t at = page.find(std::string(".SH ") + title + "\n");
    ASSERT_NE(at, std::string::npos) << title;
    EXPECT_GT(at, last) << title;
    last = at;
  }
  expect_in(page, ".TH GHOSTFORCE-RENDER 1 \"\" \"ghostforce 1.2.3\" \"User Commands\"\n.nh\n");
  expect_in(page, ".EX\nghostforce x \\-o \\(aqa\\(aq\n\nghostforce y\n.EE\n");
  expect_in(page, ".SH NAME\nghostforce\\-render \\- draw a picture\n");
}

TEST(ManPage, ALineThatBeginsWithADotIsText) {
  expect_in(page_with_notes(".png and more"), "\n\\&.png and more\n");
  expect_in(page_with_notes("Look:\n  .hidden"), "\n.EX\n\\&.hidden\n.EE\n");
  expect_in(page_with_notes("'quoted'"), "\n\\(aqquoted\\(aq\n");
}

TEST(ManPage, LongTextIsDividedAndEachSentenceEndsItsLine) {
  std::string text = "One.";
  for (int i = 0; i < 40; ++i) text += " of-many-words";
  const std::string page = page_with_notes(text + ". Two");
  expect_in(page, "\nOne.\n");
  expect_in(page, "words.\nTwo\n");
  std::size_t begin = 0;
  for (std::size_t end = page.find('\n'); end != std::string::npos; begin = end + 1, end = page.find('\n', begin)) {
    EXPECT_LE(end - begin, 80U) << page.substr(begin, end - begin);
  }
}

TEST(ManPage, OptionsSayWhatTheyTake) {
  Manual manual = manual_with_notes("");
  ManualCommand& command = manual.commands.front();
  command.arguments = {{.names = {"SCENE"}, .value = "SCENE", .sentence = "A scene", .is_required = true}};
  command.options = {
      {.names = {"-o", "--output"}, .value = "FILE", .sentence = "Where to", .is_required = true},
      {.names = {"--only"}, .value = "NAME", .sentence = "Some", .takes_many = true},
      {.names = {"--json"}, .sentence = "As JSON", .excluded = {"--only"}, .needed = {"--output"}},
  };
  const std::string page = man_page(manual, command);
  expect_in(page, "\\fBghostforce render\\fR [\\fIOPTION\\fR ...] \\fB\\-o\\fR \\fIFILE\\fR \\fISCENE\\fR\n");
  expect_in(page, ".TP\n\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\nWhere to.\nRequired.\n");
  expect_in(page, ".TP\n\\fB\\-\\-only\\fR \\fINAME\\fR ...\nSome.\n");
  expect_in(page, ".TP\n\\fB\\-\\-json\\fR\nAs JSON.\nOnly with \\-\\-output.\nNot with \\-\\-only.\n");
}

}  // namespace
}  // namespace ghostforce::man_page_test
