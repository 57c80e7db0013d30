// The exit codes of errors that know of none: files that were to be read. Pure, any thread.
#pragma once

#include "app/console/failure.h"
#include "app/files/read_error.h"

namespace ghostforce {

constexpr ExitCode exit_code_of(ReadError::Kind kind) noexcept {
  switch (kind) {
    case ReadError::Kind::wrong:
      return ExitCode::wrong_call;
    case ReadError::Kind::unreadable:
      return ExitCode::file_trouble;
  }
  return ExitCode::bug;
}

}  // namespace ghostforce
