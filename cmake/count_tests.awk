# Counts the tests in ctest's log (Testing/Temporary/LastTest.log): those that the closing lines of GoogleTest tell of,
# and 1 for each other program. The last line of all is "N passed, N failed, N skipped".

function end_of_program() {
  if (!in_program) return
  if (!ran) {
    ran = 1
    skipped = was_skipped
  }
  if ((has_failed || is_missing) && !failed) failed = 1  # it broke before it could say so
  total_failed += failed
  total_skipped += skipped
  total_passed += ran - failed - skipped
  in_program = is_missing = 0
}

# Stands before the program's first line.
/^Unable to find executable/ { end_of_program(); is_missing = 1 }
/^[0-9]+\/[0-9]+ Testing: / {
  if (!is_missing) end_of_program()
  in_program = 1
  ran = failed = skipped = was_skipped = has_failed = 0
}
/^\[==========\] [0-9]+ tests? from [0-9]+ test suites? ran\./ { ran += $2 }
/^\[  FAILED  \] [0-9]+ tests?, listed below:/ { failed += $4 }
/^\[  SKIPPED \] [0-9]+ tests?, listed below:/ { skipped += $4 }
/^Skip regular expression found in output/ { was_skipped = 1 }
/^Test Failed\.$/ { has_failed = 1 }
END {
  end_of_program()
  printf "%d passed, %d failed, %d skipped\n", total_passed, total_failed, total_skipped
}
