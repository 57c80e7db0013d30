#include "app/base/shell_word.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/program.h"

namespace ghostforce::shell_word_test {
namespace {

TEST(ShellWord, IsTakenByAShellAsItIs) {
  for (const std::string word :
       {"plain-name_1.2", "two words", "it's", "$HOME", "`x`", "a\\b", "", "~", "*", "a;b", "ü"}) {
    EXPECT_EQ(run_program("/bin/sh", {"-c", "printf %s " + shell_word(word)}).out, word);
    EXPECT_EQ(split_shell_words(shell_word(word)).words, std::vector{word});
  }
}

TEST(ShellWords, AreThoseOfAShell) {
  for (const std::string text : {
           R"(a b  c)",
           R"('a b' "c d")",
           R"(a'b'"c"d)",
           R"("a\"b\\c\d" \'x\ y)",
           "a\\\nb 'c\\\nd' \"e\\\nf\"",
           R"('' "" x)",
           R"(--set 'goal.path_mm=[[1.0, 2.0]]' a#b)",
       }) {
    std::string expected;
    for (const std::string& word : split_shell_words(text).words) expected += "<" + word + ">";
    EXPECT_EQ(run_program("/bin/sh", {"-c", "printf '<%s>' " + text}).out, expected) << text;
  }
}

TEST(ShellWords, AreSeparatedByLineBreaks) {
  EXPECT_EQ(split_shell_words("  a b\n").words, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(split_shell_words("a\r\nb").words, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(split_shell_words(" \n ").words.empty());
}

TEST(ShellWords, SayWhatIsWrong) {
  for (const std::string text :
       {"a 'b", "a \"b", "a \"b\\\"", "a\\", "a;b", "a|b", "a&", "a<b", "a>b", "(a)", "`a`", "$a", "\"$a\"", "# a"}) {
    EXPECT_FALSE(split_shell_words(text).problem.empty()) << text;
  }
}

}  // namespace
}  // namespace ghostforce::shell_word_test
