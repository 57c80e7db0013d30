// Speech: sentences for speech-dispatcher, the speech service of Linux desktops, which is asked by its own protocol
// (SSIP) over its Unix socket. Where it does not run yet it is started, as its own clients do. Nothing here waits: what
// the service cannot take now goes on at the next update(). UI thread.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/files/descriptor.h"

namespace ghostforce {

// Where the service listens: $SPEECHD_ADDRESS, else in the folder of the person's sockets. Empty: nowhere that is
// understood here.
std::filesystem::path speech_socket();

class Speech {
 public:
  static constexpr double starts_within_s = 10.0;  // the service, once asked to
  static constexpr double answers_within_s = 5.0;  // to a command

  explicit Speech(std::filesystem::path socket = speech_socket()) : path_(std::move(socket)) {}
  // What is being said ends, as far as the service listens.
  ~Speech();
  Speech(const Speech&) = delete;
  Speech& operator=(const Speech&) = delete;

  // In place of what is being said, and of what has not been begun. `language` as in "en", "es".
  void say(std::string_view words, std::string_view language);

  // Often. Returns why nothing can be spoken, and what to do; empty: all is well. After a problem it begins anew with
  // the next sentence.
  std::string update(double interval_s);

 private:
  // What the service is told in turn, each after its answer to the one before.
  enum class Step : std::uint8_t { name, cancel, language, speak, text };
  struct Sentence {
    std::string words;
    std::string language;
  };

  std::string open(double interval_s);
  std::string start_service();
  void begin_sentence();
  void prepare_step();
  std::string send_rest();
  std::string receive();
  std::string take_answer(std::string_view line);
  std::string hang_up();
  std::string lose(std::string_view why);
  void close();

  std::filesystem::path path_;
  Descriptor socket_;
  pid_t starter_ = 0;         // the process that starts the service; 0: there is none
  bool has_started_ = false;  // the service was asked to start, and has not been heard of yet
  bool has_failed_ = false;   // the process that was to start it
  double waited_s_ = 0.0;     // for the start, or for the answer
  std::deque<Step> steps_;    // the first one has been sent, or is being sent
  std::string outgoing_;      // of that step, and not sent yet
  std::string incoming_;      // not a whole line yet
  std::string language_;      // that the service has been told
  Sentence sentence_;         // being told
  std::optional<Sentence> next_;
  bool has_spoken_ = false;  // since the connection was opened
};

}  // namespace ghostforce
