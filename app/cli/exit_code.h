// The exit codes of errors that know of none: files that were to be read. Pure, any thread.
#pragma once

#include "app/base/failure.h"
#include "app/files/read_error.h"

namespace ghostforce {

constexpr ExitCode exit_code_of(ReadError::Kind kind) noexcept {
  return kind == ReadError::Kind::wrong ? ExitCode::wrong_call : ExitCode::file_trouble;
}

}  // namespace ghostforce
