// Speech against a service that answers as speech-dispatcher does, and against some that do not: silent, flooding,
// hanging up, refusing, absent. Both ends are stepped by hand; nothing waits for a clock.
#include "app/aloud/speech.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/fake_speech_service.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::speech_test {
namespace {

using Words = std::vector<std::string>;

class SpeechTest : public testing::Test {
 protected:
  // Until both have nothing more to do. Returns the first problem.
  std::string step(Speech& speech, FakeSpeechService& service, int times = 20) const {
    std::string problem;
    for (int i = 0; i < times; ++i) {
      if (std::string found = speech.update(0.01); problem.empty()) problem = std::move(found);
      service.step();
    }
    return problem;
  }
  void install_service(const std::string& script) {
    std::filesystem::create_directory(folder_ / "bin");
    write_whole(folder_ / "bin/speech-dispatcher", "#!/bin/sh\n" + script);
    chmod((folder_ / "bin/speech-dispatcher").c_str(), 0755);
    setenv("PATH", ((folder_ / "bin") + ":" + std::getenv("PATH")).c_str(), 1);
  }
  // A start takes as long as it takes.
  static std::string first_problem(Speech& speech) {
    while (true) {
      if (std::string problem = speech.update(0.0); !problem.empty()) return problem;
      std::this_thread::yield();
    }
  }

  TemporaryFolder folder_;
  std::string socket_ = folder_ / "s";
};

TEST_F(SpeechTest, SpeaksASentenceInItsLanguage) {
  FakeSpeechService service(socket_);
  Speech speech(socket_);
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.connections, 0) << "nothing is said yet";
  speech.say("The ghost force is gone.", "en");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken, Words{"The ghost force is gone."});
  EXPECT_EQ(service.commands,
            (Words{"SET SELF CLIENT_NAME user:ghostforce:stage", "CANCEL SELF", "SET SELF LANGUAGE en", "SPEAK"}));
  service.commands.clear();
  speech.say("Una", "es");
  EXPECT_EQ(step(speech, service), "");
  speech.say("Dos", "es");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.commands, (Words{"CANCEL SELF", "SET SELF LANGUAGE es", "SPEAK", "CANCEL SELF", "SPEAK"}));
  EXPECT_EQ(service.connections, 1);
}

TEST_F(SpeechTest, TheNewestSentenceWins) {
  FakeSpeechService service(socket_);
  Speech speech(socket_);
  for (const char* words : {"one", "two", "three"}) speech.say(words, "en");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken, Words{"three"});
}

TEST_F(SpeechTest, WordsAreNeverCommands) {
  FakeSpeechService service(socket_);
  Speech speech(socket_);
  speech.say(".\r\nCANCEL ALL", "en");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken, Words{"..  CANCEL ALL"});
  speech.say("next", "en");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken.back(), "next");
}

TEST_F(SpeechTest, EndsWhatIsBeingSaidWhenItIsSwitchedOff) {
  FakeSpeechService service(socket_);
  {
    Speech speech(socket_);
    speech.say("a long sentence", "en");
    EXPECT_EQ(step(speech, service), "");
    service.commands.clear();
  }
  service.step();
  EXPECT_EQ(service.commands, (Words{"CANCEL SELF", "QUIT"}));
}

TEST_F(SpeechTest, ASilentServiceIsGivenUp) {
  FakeSpeechService service(socket_);
  service.answer = [](const std::string&) { return std::string(); };
  Speech speech(socket_);
  speech.say("hello", "en");
  const int steps = static_cast<int>(Speech::answers_within_s / 0.01);
  EXPECT_EQ(step(speech, service, steps - 10), "");
  EXPECT_EQ(step(speech, service, 20), "Nothing can be spoken: the speech service does not answer.");
  service.answer = FakeSpeechService::usual_answer;
  speech.say("again", "en");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken, Words{"again"});
}

// Takes nothing from its socket: what cannot be sent stays with us, and the newest sentence still wins.
TEST_F(SpeechTest, AServiceThatDoesNotReadHoldsNothingUp) {
  FakeSpeechService service(socket_);
  Speech speech(socket_);
  speech.say(std::string(4000000, 'a'), "en");
  service.answer = [](const std::string& line) { return FakeSpeechService::usual_answer(line); };
  while (service.commands.empty() || service.commands.back() != "SPEAK") {
    ASSERT_EQ(speech.update(0.0), "");
    service.step();
  }
  for (int i = 0; i < 100; ++i) {
    speech.say(std::to_string(i), "en");
    ASSERT_EQ(speech.update(0.01), "");
  }
  EXPECT_EQ(step(speech, service, 2000), "");
  ASSERT_EQ(service.spoken.size(), 2U);
  EXPECT_EQ(service.spoken[0].size(), 4000000U);
  EXPECT_EQ(service.spoken[1], "99");
}

TEST_F(SpeechTest, AFloodIsTakenInPieces) {
  FakeSpeechService service(socket_);
  Speech speech(socket_);
  speech.say("hello", "en");
  ASSERT_EQ(step(speech, service), "");
  // Events, answers to nothing and half answers.
  std::string flood;
  while (flood.size() < 100000) flood += "701-12\r\n701 BEGIN\r\n299 WHAT\r\nxx\r\n\r\n225-";
  service.send_to_client(flood + "\r\n");
  for (int i = 0; i < 100; ++i) ASSERT_EQ(speech.update(0.0), "");
  speech.say("still here", "en");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken, (Words{"hello", "still here"}));
  // A line without an end is no answer at all.
  service.send_to_client(std::string(50000, 'x'));
  EXPECT_EQ(speech.update(0.0), "Nothing can be spoken: the speech service does not speak its own protocol.");
}

TEST_F(SpeechTest, AServiceThatHangsUpIsTriedOnceMore) {
  FakeSpeechService service(socket_);
  Speech speech(socket_);
  speech.say("one", "en");
  ASSERT_EQ(step(speech, service), "");
  service.hang_up();
  speech.say("two", "en");
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken, (Words{"one", "two"}));
  EXPECT_EQ(service.connections, 2);
  // And not again and again.
  service.answer = [&](const std::string&) {
    service.hang_up();
    return std::string();
  };
  speech.say("three", "en");
  EXPECT_EQ(step(speech, service), "Nothing can be spoken: the speech service has hung up.");
  EXPECT_LE(service.connections, 3);
}

TEST_F(SpeechTest, ARefusedSentenceIsSaidSoAndItsWordsAreNotSent) {
  FakeSpeechService service(socket_);
  service.answer = [](const std::string& line) {
    return line == "SPEAK" ? std::string("300 ERR INTERNAL\r\n") : std::string("400 ERR\r\n");
  };
  Speech speech(socket_);
  speech.say("CANCEL ALL", "en");
  const std::string problem = step(speech, service);
  EXPECT_EQ(problem.find("Nothing can be spoken: the speech service answers '300 ERR INTERNAL"), 0U) << problem;
  EXPECT_EQ(service.spoken, Words{});
  EXPECT_EQ(service.commands.back(), "SPEAK");
}

TEST_F(SpeechTest, WithoutTheServiceItSaysWhatToInstall) {
  setenv("PATH", folder_.path().c_str(), 1);
  Speech speech(socket_);
  speech.say("hello", "en");
  EXPECT_EQ(speech.update(0.0), "Nothing can be spoken: Install the package speech-dispatcher.");
  EXPECT_EQ(speech.update(0.0), "") << "said once";
}

TEST_F(SpeechTest, StartsTheServiceAndWaitsForIt) {
  install_service("printf '%s ' \"$@\" > '" + (folder_ / "begun") + "'\nmv '" + (folder_ / "begun") + "' '" +
                  (folder_ / "asked") + "'\n");
  Speech speech(socket_);
  speech.say("hello", "en");
  while (!std::filesystem::exists(folder_ / "asked")) {
    ASSERT_EQ(speech.update(0.0), "");
    std::this_thread::yield();
  }
  EXPECT_EQ(read_whole(folder_ / "asked"), "--spawn --communication-method unix_socket --socket-path " + socket_ + " ");
  EXPECT_EQ(speech.update(1.0), "");
  FakeSpeechService service(socket_);
  EXPECT_EQ(step(speech, service), "");
  EXPECT_EQ(service.spoken, Words{"hello"});
}

TEST_F(SpeechTest, AServiceThatDoesNotStartIsSaidSo) {
  install_service("exit 1\n");
  Speech speech(socket_);
  speech.say("hello", "en");
  EXPECT_EQ(first_problem(speech),
            "Nothing can be spoken: speech-dispatcher has not started. Run spd-say hello in a terminal to see why.");
  // It says that it has started, and has not.
  install_service("exit 0\n");
  speech.say("hello", "en");
  EXPECT_EQ(speech.update(0.0), "");
  EXPECT_EQ(speech.update(Speech::starts_within_s), "");
  EXPECT_NE(speech.update(1.0), "");
}

TEST_F(SpeechTest, FindsTheSocketAsItsClientsDo) {
  setenv("XDG_RUNTIME_DIR", "/run/user/7", 1);
  unsetenv("SPEECHD_ADDRESS");
  EXPECT_EQ(speech_socket(), "/run/user/7/speech-dispatcher/speechd.sock");
  setenv("SPEECHD_ADDRESS", "unix_socket", 1);
  EXPECT_EQ(speech_socket(), "/run/user/7/speech-dispatcher/speechd.sock");
  setenv("SPEECHD_ADDRESS", "unix_socket:/a/b", 1);
  EXPECT_EQ(speech_socket(), "/a/b");
  setenv("SPEECHD_ADDRESS", "inet_socket:host:6560", 1);
  Speech elsewhere;
  elsewhere.say("hello", "en");
  EXPECT_NE(elsewhere.update(0.0).find("Give unix_socket:PATH"), std::string::npos);
  unsetenv("SPEECHD_ADDRESS");
  Speech far_down(folder_ / std::string(200, 'x'));
  far_down.say("hello", "en");
  EXPECT_NE(far_down.update(0.0).find("cannot be reached"), std::string::npos);
}

}  // namespace
}  // namespace ghostforce::speech_test
