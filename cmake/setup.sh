# What ./demo, ./check, .ci/run and .ci/long share; sourced by them, never run. Needs bash and Debian's essential packages
# only. All it says goes to stderr, because stdout belongs to the program; what it runs speaks into build/*.log.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '%s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }

log_of() { printf '%s' "$root/build/$1.log"; }

# Each step of .ci says what it is when it starts and how long it took when it ends.
begin() { step=$1 started=$SECONDS && say "== $step"; }
end() { say "== $step: $((SECONDS - started)) s"; }

# logged NAME COMMAND...: runs it with its words in a log and nothing to read; returns its status.
logged() {
  mkdir -p "$root/build"
  "${@:2}" >"$(log_of "$1")" 2>&1 </dev/null
}

# fail_with NAME MESSAGE: shows the log where it matters. The first error is the one to read, those after it may only
# follow from it.
fail_with() {
  local log
  log=$(log_of "$1")
  grep --max-count=1 --after-context=60 '^FAILED: \|^CMake Error\|^E: ' "$log" >&2 || tail -n 40 "$log" >&2
  fail "$2 All of it is in $log."
}

# ---- Packages --------------------------------------------------------------------------------------------------------

# packages_of SECTION...: prints those of these sections of packages.txt, one a line.
packages_of() {
  local name section=''
  while read -r name _; do
    case $name in
      '' | '#'*) ;;
      '['*) section=${name//[\[\]]/} ;;
      *) [[ " $* " != *" $section "* ]] || printf '%s\n' "$name" ;;
    esac
  done <"$root/packages.txt"
}

# those_there NAME...: prints them without those that packages.txt calls optional and that this system does not have.
those_there() {
  local name
  for name in "$@"; do
    grep -q "^$name optional\$" "$root/packages.txt" && ! apt-cache show "$name" >/dev/null 2>&1 || printf '%s\n' "$name"
  done
}

# install_packages SECTION...: installs what is missing of these sections; calls no apt when nothing is.
install_packages() {
  local wanted
  mapfile -t wanted < <(packages_of "$@")

  if ! command -v dpkg-query >/dev/null; then
    say "This is not Debian or a system based on it. $root/packages.txt names the packages that the build needs."
    return
  fi
  local name status missing=()
  local -A installed=()
  while read -r name status; do
    [[ $status != installed ]] || installed[$name]=yes
  done < <(dpkg-query --show --showformat '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null)
  for name in "${wanted[@]}"; do
    [[ ${installed[$name]:-} ]] || missing+=("$name")
  done
  [[ $(those_there "${missing[@]}") ]] || return 0

  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "Packages are missing, and only root can install them. As root, run
  apt-get install --no-install-recommends ${missing[*]}
and start this again."
    as_root=(sudo)
  fi
  say "Installing ${#missing[@]} Debian packages and what they need: ${missing[*]}"
  # A fresh machine may be updating itself just now: wait for its lock.
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --yes -o DPkg::Lock::Timeout=300)
  logged packages "${apt[@]}" update ||
    say "apt-get update did not reach every package source; trying with the existing lists."
  mapfile -t missing < <(those_there "${missing[@]}")
  logged packages "${apt[@]}" install --no-install-recommends "${missing[@]}" ||
    fail_with packages "The packages could not be installed."
}

# ---- Build -----------------------------------------------------------------------------------------------------------

# What was compiled once is not compiled again, in whichever folder the checkout lies: the cache is outside it, paths count
# from the checkout on, and precompiled headers are known by what is in them. What a source includes the compiler itself
# says (depend), so that none is preprocessed only to be looked up.
use_ccache() {
  command -v ccache >/dev/null || return 0
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=yes CCACHE_DEPEND=yes CCACHE_SLOPPINESS=pch_defines,time_macros
}

# build PRESET TARGET [-DNAME=VALUE...]: builds, in at most one process at a time. Configures, with these values, only
# where there is no usable build tree: when nothing changed, this is one ninja that finds nothing to do.
build() {
  local preset=$1 target=$2 settings=("${@:3}") tree=$root/build/$1 lock
  mkdir -p "$root/build"
  exec {lock}>"$root/build/.lock"
  flock --nonblock "$lock" || { say "Waiting for another build to end"; flock "$lock"; }

  if [[ ! -e $tree/build.ninja ]] || is_foreign "$tree"; then
    configure "$preset" "${settings[@]}"
  fi
  local status=0
  run_ninja "$preset" "$target" || status=$?
  # An error of ninja itself is no error in the code: the tree is broken, after an upgrade of the system for instance.
  if ((status)) && grep -q '^ninja: error: ' "$(log_of "$preset")"; then
    rm -f "$tree/CMakeCache.txt"
    configure "$preset" "${settings[@]}"
    status=0
    run_ninja "$preset" "$target" || status=$?
  fi
  ((status == 0)) || fail_with "$preset" "The build failed."
  exec {lock}>&-
}

# configure_and_build PRESET TARGET [-DNAME=VALUE...]: for a tree that may have been configured with other values.
configure_and_build() {
  is_configured "$1" "${@:3}" || configure "$1" "${@:3}"
  build "$@"
}

# is_configured PRESET [-DNAME=VALUE...]: whether a tree has been configured with these values before.
is_configured() {
  local setting tree=$root/build/$1
  [[ $tree/build.ninja -nt $root/CMakePresets.json ]] || return 1  # which CMake does not look at by itself
  for setting in "${@:2}"; do
    grep -Fxq -e "${setting#-D}" <(sed 's/^\([^:]*\):[A-Z]*=/\1=/' "$tree/CMakeCache.txt") || return 1
  done
}

# configure PRESET [-DNAME=VALUE...]
configure() {
  local preset=$1 tree=$root/build/$1
  say "Configuring $preset"
  if is_foreign "$tree"; then
    rm -rf "$tree"
  elif [[ -e $tree/CMakeCache.txt && $tree/build.ninja -nt $root/CMakePresets.json ]]; then
    # Else its cache may be what is in the way: it keeps what is no longer in the presets.
    logged "$preset" cmake -S "$root" --preset "$@" && return
  fi
  logged "$preset" cmake -S "$root" --fresh --preset "$@" || fail_with "$preset" "The build could not be configured."
}

# is_foreign TREE: whether it was configured for another place (a checkout that was moved) or another build tool.
is_foreign() {
  [[ -e $1/CMakeCache.txt ]] || return 1
  local line cache
  cache=$(<"$1/CMakeCache.txt")
  for line in "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "CMAKE_CACHEFILE_DIR:INTERNAL=$1" CMAKE_GENERATOR:INTERNAL=Ninja; do
    [[ $cache == *$'\n'"$line"$'\n'* ]] || return 0
  done
  return 1
}

# run_ninja PRESET TARGET: shows how far it is; says nothing when there is nothing to do.
run_ninja() {
  local line started=
  ninja -C "$root/build/$1" "$2" 2>&1 </dev/null | {
    while IFS= read -r line; do
      printf '%s\n' "$line"
      [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
      if [[ -t 2 ]]; then
        printf '\rBuilding: step %s of %s\e[K' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
      elif [[ ! $started ]]; then
        say "Building: ${BASH_REMATCH[2]} steps"
      fi
      started=yes
    done
    [[ ! $started || ! -t 2 ]] || printf '\r\e[K' >&2
  } >"$(log_of "$1")"
}

# ---- Tests -----------------------------------------------------------------------------------------------------------

# run_tests PRESET [ARGUMENTS of ctest]: programs as a whole; with -R or -E, which are about names, test by test. The last
# line counts the tests, of which ctest sees none in a program that it runs as a whole. There are three slots for each
# core, as tests that compute wait now and then too. Under a sanitizer there are two: with more, devices would not be
# ready in time. Those with the label long are for .ci/long alone, which sets GHOSTFORCE_LONG.
run_tests() {
  local tree=$root/build/$1 status=0 log=$root/build/$1/Testing/Temporary/LastTest.log slots=3
  [[ $1 != [at]san ]] || slots=2
  ( # its environment is its own
    case " ${*:2} " in
      *' --rerun-failed '*) ;;  # as the last time: those that failed are known by their numbers
      *' -R'* | *' -E'* | *' --tests-regex'* | *' --exclude-regex'*) touch "$tree/test_by_test" ;;
      *) rm -f "$tree/test_by_test" ;;
    esac
    [[ ! -e $tree/test_by_test ]] || export GHOSTFORCE_TEST_BY_TEST=yes
    rm -f "$log"
    local left_out=()
    [[ ${GHOSTFORCE_LONG:-} ]] || left_out=(--label-exclude '^long$')
    ctest --test-dir "$tree" --parallel "$((slots * $(nproc)))" --output-on-failure --no-tests=error "${left_out[@]}" \
      "${@:2}"
  ) || status=$?
  [[ ! -e $log ]] || awk -f "$root/cmake/count_tests.awk" "$log"
  return $status
}

# tidy REGEX: clang-tidy over the sources that match, as the preset fuzz compiles them, which must have been built: it
# is clang's, and makes the headers that others include.
tidy() {
  logged tidy run-clang-tidy-16 -quiet -p "$root/build/fuzz" -j "$(nproc)" "$1" || {
    grep --after-context=3 ': \(error\|warning\): ' "$(log_of tidy)" | head -n 100 >&2
    fail "clang-tidy has something to say. All of it is in $(log_of tidy)."
  }
}
