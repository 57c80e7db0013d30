// Speech by a tool that writes down how it was called, and by some that hang, fail or are not there. A tool takes as
// long as it takes; nothing here looks at a clock.
#include "app/cli/speech.h"

#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/fake_speech_tool.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::speech_test {
namespace {

using Words = std::vector<std::string>;

constexpr const char* as_long_as_it_may = "exec sleep 1000";
const std::string before = "--application-name ghostforce --wait --language ";

Words calls_after(const FakeSpeechTool& tool, std::size_t count) {
  while (tool.calls().size() < count) std::this_thread::yield();
  return tool.calls();
}

// What update() says until every tool has ended.
std::string words_until_the_end(Speech& speech) {
  std::string words;
  siginfo_t info{};
  while (waitid(P_ALL, 0, &info, WEXITED | WNOWAIT) == 0) words += speech.update(0.0);
  EXPECT_EQ(errno, ECHILD);
  return words;
}

TEST(Speech, SpeaksASentenceInItsLanguage) {
  const FakeSpeechTool tool;
  Speech speech;
  EXPECT_EQ(speech.update(0.1), "");
  EXPECT_EQ(speech.say("The ghost force is gone.", "en"), "");
  EXPECT_EQ(words_until_the_end(speech), "");
  EXPECT_EQ(speech.say("Una", "es"), "");
  EXPECT_EQ(words_until_the_end(speech), "");
  EXPECT_EQ(tool.calls(), (Words{before + "en -- The ghost force is gone.", before + "es -- Una"}));
}

TEST(Speech, ANewerSentenceInterrupts) {
  const FakeSpeechTool tool(as_long_as_it_may);
  Speech speech;
  ASSERT_EQ(speech.say("one", "en"), "");
  calls_after(tool, 1);
  EXPECT_EQ(speech.update(1.0), "");
  tool.behave("exit 0");
  ASSERT_EQ(speech.say("two", "en"), "");
  EXPECT_EQ(words_until_the_end(speech), "") << "both have ended, and neither is missed";
  EXPECT_EQ(tool.calls(), (Words{before + "en -- one", "--cancel " + before + "en -- two"}));
}

TEST(Speech, WordsAreNoOptionsAndNoFormat) {
  const FakeSpeechTool tool;
  Speech speech;
  ASSERT_EQ(speech.say("--cancel 100 %s", "en"), "");
  words_until_the_end(speech);
  EXPECT_EQ(tool.calls(), (Words{before + "en -- --cancel 100 %%s"}));
}

TEST(Speech, EndsWhatIsBeingSaidAndNothingElse) {
  const FakeSpeechTool tool(as_long_as_it_may);
  Speech speech;
  speech.end();
  ASSERT_EQ(speech.say("a long sentence", "en"), "");
  calls_after(tool, 1);
  tool.behave("exit 0");
  speech.end();
  speech.end();
  EXPECT_EQ(words_until_the_end(speech), "");
  EXPECT_EQ(tool.calls(), (Words{before + "en -- a long sentence", "--cancel"}));
}

TEST(Speech, ASilentServiceIsGivenUp) {
  const FakeSpeechTool tool(as_long_as_it_may);
  Speech speech;
  ASSERT_EQ(speech.say("hello", "en"), "");
  EXPECT_EQ(speech.update(Speech::speaks_within_s), "");
  EXPECT_EQ(speech.update(0.1), "Nothing can be spoken: the speech service does not answer.");
  EXPECT_EQ(words_until_the_end(speech), "") << "said once";
  tool.behave("exit 0");
  ASSERT_EQ(speech.say("again", "en"), "");
  EXPECT_EQ(words_until_the_end(speech), "");
}

TEST(Speech, ARefusedSentenceIsSaidOnce) {
  const FakeSpeechTool tool("exit 1");
  Speech speech;
  ASSERT_EQ(speech.say("hello", "en"), "");
  EXPECT_EQ(words_until_the_end(speech),
            "Nothing can be spoken: the speech service has not taken the sentence. Run spd-say hello in a terminal to "
            "see why.");
  EXPECT_EQ(speech.update(Speech::speaks_within_s + 1.0), "");
}

TEST(Speech, WithoutTheToolItSaysWhatToInstall) {
  const TemporaryFolder empty;
  const std::string path = std::getenv("PATH");
  setenv("PATH", empty.path().c_str(), 1);
  Speech speech;
  EXPECT_EQ(speech.say("hello", "en"), "Nothing can be spoken: Install the package speech-dispatcher.");
  EXPECT_EQ(speech.update(0.0), "") << "said once";
  setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace ghostforce::speech_test
