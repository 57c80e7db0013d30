# What clang warns of, of which g++ does not; and whether each source can be compiled by itself, where other presets
# compile several together. Sourced after setup.sh.

# clang_warnings [COMMIT]: of the sources that differ from that commit, and those that include what does
# (cmake/changed_sources.py, which also says from which commit on if none is named). They are read and not compiled
# (cmake/syntax_check.py). Where these are many, all are read in the batches in which they are compiled, which takes less
# than half the time. What clang has just compiled for the address sanitizer is then left out. .ci/long reads each source
# by itself, and what is compiled only without a sanitizer. Benches are among them where their library is installed.
clang_warnings() {
  local benches=OFF list changed preset=clang many=150
  [[ ! -e /usr/include/benchmark/benchmark.h ]] || benches=ON
  [[ $benches == ON ]] || say "Without the benches: libbenchmark-dev is not installed."
  list=$("$root/cmake/changed_sources.py" "$@") || fail "What has changed is not known."
  [[ $list ]] || { say "No source has changed."; return; }
  mapfile -t changed <<<"$list"
  if ((${#changed[@]} > many)); then
    preset=clang-batches changed=()
    ! is_configured asan -DGHOSTFORCE_WARNINGS_AS_ERRORS=ON || changed=(--but-of "$root/build/asan" asan_tests bench/all)
  fi
  # The headers that are made by the build, not when it is configured.
  configure_and_build $preset generated/glad/include/glad/gl.h \
    -DBUILD_TESTING=ON -DGHOSTFORCE_WARNINGS_AS_ERRORS=ON -DGHOSTFORCE_BENCH=$benches
  build $preset generated/embedded/embedded_languages.h
  logged clang-warnings "$root/cmake/syntax_check.py" "$root/build/$preset" "${changed[@]}" ||
    fail_with clang-warnings "clang has something to say."
  say "clang has nothing to say of what changed: $(tail -n 1 "$(log_of clang-warnings)")"
}
