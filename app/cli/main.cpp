#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/files/output_file.h"
#include "device/motors/emergency_stop.h"

namespace {

// Where one of the three standard streams is closed, the next file that is opened would take its place, and words would
// go into data.
void fill_standard_streams() noexcept {
  int descriptor = 0;
  do {
    descriptor = open("/dev/null", O_RDONLY);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) close(descriptor);
}

int say_bug(const char* what) noexcept {
  using namespace ghostforce;
  write_words("This is a bug in ghostforce: ");
  write_words(what);
  write_words(". Please report it, with the command line and the files used.\n");
  return static_cast<int>(ExitCode::bug);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace ghostforce;
  fill_standard_streams();
  remember_interruptions(emergency_stop::stop_motors);
  emergency_stop::install_handlers();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is found when writing
  std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that may not grow
  try {
    return parse_command_line(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc))();
  } catch (const BrokenPipe&) {
    return static_cast<int>(ExitCode::done);
  } catch (const Failure& failure) {
    say("{}\n", failure.what());
    return static_cast<int>(failure.code());
  } catch (const ReadError& error) {
    say("{}\n", error.what());
    return static_cast<int>(exit_code_of(error.kind()));
  } catch (const std::bad_alloc&) {
    write_words("There is not enough memory for this. Close other programs, or raise this one's limit (ulimit -v).\n");
    return static_cast<int>(ExitCode::file_trouble);
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) return say_bug(error.what());
    write_words(
        "The system does not let this program start another thread. Close other programs, or raise this one's limits "
        "(ulimit -u, ulimit -v).\n");
    return static_cast<int>(ExitCode::file_trouble);
  } catch (const std::exception& error) {
    return say_bug(error.what());
  } catch (...) {
    return say_bug("an unknown exception was thrown");
  }
}
