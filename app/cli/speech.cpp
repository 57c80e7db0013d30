#include "app/cli/speech.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "app/files/descriptor.h"
#include "app/files/tool_process.h"

namespace ghostforce {

std::optional<std::string> SettledSentence::take(std::string_view sentence, double interval_s) {
  if (sentence != seen_) {
    seen_ = sentence;
    stands_s_ = 0.0;
    return std::nullopt;
  }
  stands_s_ += interval_s;
  if (stands_s_ < settles_in_s || seen_ == taken_) return std::nullopt;
  taken_ = seen_;
  return taken_;
}

namespace {

std::string nothing_spoken(std::string_view why) {
  return fmt::format("Nothing can be spoken: {}", why);
}

// The tool takes its argument for a format of printf, and speaks what that makes.
std::string as_format(std::string_view words) {
  std::string format;
  for (const char letter : words) format += letter == '%' ? "%%" : std::string(1, letter);
  return format;
}

}  // namespace

std::string Speech::say(std::string_view words, std::string_view language) {
  std::vector<std::string> call{"spd-say"};
  if (silence()) call.emplace_back("--cancel");
  call.insert(call.end(), {"--application-name", "ghostforce", "--wait", "--language", std::string(language), "--",
                           as_format(words)});
  const int error = start(call, speaking_);
  if (error == ENOENT) return nothing_spoken("Install the package speech-dispatcher.");
  if (error != 0)
    return nothing_spoken(fmt::format("spd-say cannot be started: {}.", std::generic_category().message(error)));
  return {};
}

std::string Speech::update(double interval_s) {
  std::string problem;
  std::erase_if(children_, [&](pid_t child) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == 0) return false;
    if (child != speaking_) return true;
    speaking_ = 0;
    if (ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
    problem =
        nothing_spoken("the speech service has not taken the sentence. Run spd-say hello in a terminal to see why.");
    return true;
  });
  if (speaking_ == 0) return problem;
  speaks_since_s_ += interval_s;
  if (speaks_since_s_ <= speaks_within_s) return {};
  silence();
  return nothing_spoken("the speech service does not answer.");
}

void Speech::end() {
  pid_t cancelling = 0;
  if (silence()) start({"spd-say", "--cancel"}, cancelling);
}

bool Speech::silence() {
  if (speaking_ == 0) return false;
  kill(speaking_, SIGKILL);
  speaking_ = 0;
  return true;
}

int Speech::start(const std::vector<std::string>& words, pid_t& child) {
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const int error = start_tool(words, {.in = nothing.number()}, child);
  if (error == 0) {
    children_.push_back(child);
  } else {
    child = 0;
  }
  speaks_since_s_ = 0.0;
  return error;
}

}  // namespace ghostforce
