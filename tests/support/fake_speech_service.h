// FakeSpeechService: the other end of the speech service's socket, which answers as speech-dispatcher does unless it is told
// otherwise. It is stepped by hand.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/descriptor.h"

namespace ghostforce {

class FakeSpeechService {
 public:
  explicit FakeSpeechService(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path.data(), path.size());
    listening_.reset(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    EXPECT_EQ(bind(listening_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    EXPECT_EQ(listen(listening_.number(), 4), 0);
  }

  // What is answered to a line; empty: nothing. By default what speech-dispatcher 0.11 answers.
  std::function<std::string(const std::string&)> answer = usual_answer;

  std::vector<std::string> commands;
  std::vector<std::string> spoken;  // texts, as they came
  int connections = 0;

  // Takes what there is, and answers it.
  void step() {
    if (const int client = accept4(listening_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC); client >= 0) {
      client_.reset(client);
      ++connections;
      incoming_.clear();
      takes_text_ = false;
    }
    char piece[4096];
    ssize_t received = 0;
    while (client_.number() >= 0 && (received = recv(client_.number(), piece, sizeof(piece), 0)) > 0) {
      incoming_.append(piece, static_cast<std::size_t>(received));
      for (std::size_t end = 0; (end = incoming_.find("\r\n")) != std::string::npos;) {
        const std::string line = incoming_.substr(0, end);
        incoming_.erase(0, end + 2);
        take(line);
      }
    }
  }
  void send_to_client(const std::string& text) const {
    send(client_.number(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  }
  void hang_up() { client_.reset(); }

  static std::string usual_answer(const std::string& line) {
    if (line == "SPEAK") return "230 OK RECEIVING DATA\r\n";
    if (line == ".") return "225-7\r\n225 OK MESSAGE QUEUED\r\n";
    return "200 OK\r\n";
  }

 private:
  void take(const std::string& line) {
    if (takes_text_ && line != ".") {
      spoken.push_back(line);
      return;
    }
    if (!takes_text_) commands.push_back(line);
    takes_text_ = line == "SPEAK";
    if (const std::string words = answer(line); !words.empty()) send_to_client(words);
  }

  Descriptor listening_;
  Descriptor client_;
  std::string incoming_;
  bool takes_text_ = false;
};

}  // namespace ghostforce
