#include "app/aloud/speech.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "app/console/quoted.h"
#include "app/files/tool_process.h"

namespace ghostforce {
namespace {

constexpr std::string_view new_line = "\r\n";
constexpr std::size_t longest_answer = 4096;  // [bytes]
constexpr int pieces_per_update = 16;         // however much the service sends
constexpr std::string_view install_words = "Install the package speech-dispatcher.";

// A line of SSIP ends nowhere else, and one that begins with a dot has a second one.
std::string as_data(std::string words) {
  std::ranges::replace_if(
      words, [](char letter) { return static_cast<unsigned char>(letter) < ' '; }, ' ');
  return fmt::format("{}{}{}.{}", words.starts_with('.') ? "." : "", words, new_line, new_line);
}

std::string reason_for(int error) {
  return std::generic_category().message(error);
}

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

// 0, or errno. The socket is open then.
int connect_to(const std::filesystem::path& path, Descriptor& opened) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string& name = path.native();
  if (name.size() >= sizeof(address.sun_path)) return ENAMETOOLONG;
  std::memcpy(address.sun_path, name.data(), name.size());
  opened.reset(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (opened.number() < 0) return errno;
  if (connect(opened.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) return 0;
  const int error = errno;
  opened.reset();
  return error;
}

}  // namespace

std::filesystem::path speech_socket() {
  constexpr std::string_view unix_socket = "unix_socket";
  if (const std::string_view address = variable("SPEECHD_ADDRESS"); !address.empty() && address != unix_socket) {
    const std::string prefix = fmt::format("{}:", unix_socket);
    return address.starts_with(prefix) ? std::filesystem::path(address.substr(prefix.size())) : std::filesystem::path();
  }
  std::filesystem::path folder = variable("XDG_RUNTIME_DIR");
  if (folder.empty()) folder = variable("XDG_CACHE_HOME");
  if (folder.empty()) folder = std::filesystem::path(variable("HOME")) / ".cache";
  return folder / "speech-dispatcher" / "speechd.sock";
}

Speech::~Speech() {
  if (socket_.number() < 0 || !steps_.empty()) return;
  constexpr std::string_view farewell = "CANCEL SELF\r\nQUIT\r\n";
  [[maybe_unused]] const ssize_t sent =
      send(socket_.number(), farewell.data(), farewell.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

void Speech::say(std::string_view words, std::string_view language) {
  next_ = Sentence{std::string(words), std::string(language)};
}

std::string Speech::update(double interval_s) {
  int status = 0;
  if (starter_ != 0 && waitpid(starter_, &status, WNOHANG) == starter_) {
    starter_ = 0;
    has_failed_ = status != 0;
  }
  if (socket_.number() < 0) {
    if (!next_) return {};
    if (std::string problem = open(interval_s); !problem.empty() || socket_.number() < 0) return problem;
  }
  if (std::string problem = receive(); !problem.empty() || socket_.number() < 0) return problem;
  if (steps_.empty()) {
    if (!next_) return {};
    begin_sentence();
  }
  waited_s_ += interval_s;
  if (waited_s_ > answers_within_s) return lose("the speech service does not answer.");
  return send_rest();
}

std::string Speech::open(double interval_s) {
  if (path_.empty()) {
    return lose("SPEECHD_ADDRESS names no socket that ghostforce can use. Give unix_socket:PATH.");
  }
  const int error = connect_to(path_, socket_);
  if (error == 0) {
    has_started_ = false;
    has_spoken_ = false;
    language_.clear();
    incoming_.clear();
    steps_ = {Step::name};
    prepare_step();
    return {};
  }
  const bool may_come = error == ENOENT || error == ECONNREFUSED || error == EAGAIN;
  if (!may_come) return lose(fmt::format("the speech service cannot be reached: {}.", reason_for(error)));
  if (!has_started_) return start_service();
  waited_s_ += interval_s;
  if (has_failed_ || waited_s_ > starts_within_s) {
    return lose("speech-dispatcher has not started. Run spd-say hello in a terminal to see why.");
  }
  return {};
}

std::string Speech::start_service() {
  const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const int error = start_tool(
      {"speech-dispatcher", "--spawn", "--communication-method", "unix_socket", "--socket-path", path_.string()},
      {.in = nothing.number()}, starter_);
  if (error == ENOENT) return lose(std::string(install_words));
  if (error != 0) return lose(fmt::format("speech-dispatcher cannot be started: {}.", reason_for(error)));
  has_started_ = true;
  has_failed_ = false;
  waited_s_ = 0.0;
  return {};
}

void Speech::begin_sentence() {
  sentence_ = std::move(*next_);
  next_.reset();
  steps_ = {Step::cancel, Step::language, Step::speak, Step::text};
  if (sentence_.language == language_) std::erase(steps_, Step::language);
  prepare_step();
}

void Speech::prepare_step() {
  waited_s_ = 0.0;
  switch (steps_.front()) {
    case Step::name:
      outgoing_ = "SET SELF CLIENT_NAME user:ghostforce:stage";
      break;
    case Step::cancel:
      outgoing_ = "CANCEL SELF";
      break;
    case Step::language:
      outgoing_ = "SET SELF LANGUAGE " + sentence_.language;
      language_ = sentence_.language;
      break;
    case Step::speak:
      outgoing_ = "SPEAK";
      break;
    case Step::text:
      outgoing_ = as_data(sentence_.words);
      return;
  }
  outgoing_ += new_line;
}

std::string Speech::send_rest() {
  while (!outgoing_.empty()) {
    const ssize_t sent = send(socket_.number(), outgoing_.data(), outgoing_.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) {
      outgoing_.erase(0, static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN) {
      return {};
    } else if (errno != EINTR) {
      return hang_up();
    }
  }
  return {};
}

std::string Speech::receive() {
  for (int i = 0; i < pieces_per_update; ++i) {
    char piece[longest_answer];
    const ssize_t received = recv(socket_.number(), piece, sizeof(piece), MSG_DONTWAIT);
    if (received < 0 && errno == EINTR) continue;
    if (received < 0 && errno == EAGAIN) return {};
    if (received <= 0) return hang_up();
    incoming_.append(piece, static_cast<std::size_t>(received));
    std::size_t end = 0;
    while ((end = incoming_.find('\n')) != std::string::npos) {
      const std::string line = incoming_.substr(0, end);
      incoming_.erase(0, end + 1);
      if (std::string problem = take_answer(line); !problem.empty()) return problem;
    }
    if (incoming_.size() > longest_answer) return lose("the speech service does not speak its own protocol.");
  }
  return {};
}

std::string Speech::take_answer(std::string_view line) {
  const bool is_whole = line.size() > 3 && line[3] == ' ';
  const bool is_event = line.starts_with('7');  // of what is being spoken
  if (!is_whole || is_event || steps_.empty() || !outgoing_.empty()) return {};
  const Step step = steps_.front();
  const bool is_refused = !line.starts_with('2');
  if (is_refused && (step == Step::speak || step == Step::text)) {
    return lose(fmt::format("the speech service answers '{}'.", quoted_text(line)));
  }
  steps_.pop_front();
  if (step == Step::text) has_spoken_ = true;
  if (!steps_.empty()) prepare_step();
  return {};
}

// The service has closed the connection. One that worked is worth another try.
std::string Speech::hang_up() {
  if (!steps_.empty() && !has_spoken_) return lose("the speech service has hung up.");
  if (!steps_.empty() && !next_) next_ = sentence_;
  close();
  return {};
}

std::string Speech::lose(std::string_view why) {
  close();
  next_.reset();
  has_started_ = false;
  return fmt::format("Nothing can be spoken: {}", why);
}

void Speech::close() {
  socket_.reset();
  steps_.clear();
  outgoing_.clear();
}

}  // namespace ghostforce
