# What the page was made of when its tests last passed, kept beside it in build/web. Sourced by ./check after setup.sh:
# where nothing changed since, there is nothing to test.

page=$root/build/web/ghostforce.html

# made_of_page: a hash of all that the page is made of, that it is compared with and that its tests are made of. Without
# git, which a copy of the sources need not have. A newer browser is something new to test too.
made_of_page() {
  (
    set -e  # which $(...) does not hand on
    cd "$root"
    {
      find app assets cmake core device shaders tests/web -name __pycache__ -prune -o -type f -print0
      printf '%s\0' CMakeLists.txt CMakePresets.json LICENSE THIRD_PARTY_NOTICES.md check docs/web.md docs/course-page.html web
    } | LC_ALL=C sort --zero-terminated | xargs -0 sha256sum
    packages_of build run page web
    # shellcheck disable=SC2046  # a word each
    dpkg-query --show $(packages_of browsers) 2>/dev/null || true
    printf '%s\n' "${CI:+warnings are errors}"
  ) | sha256sum | cut -c 1-64
}

# tested_page [ARGUMENTS of ctest]: the file that says what passed with these.
tested_page() { printf '%s' "$root/build/web/tested-$(printf '%s\n' "$@" | sha256sum | cut -c 1-12)"; }

# tested_now MADE_OF: what stands in that file; the page's own bytes are part of it.
tested_now() { printf '%s %s\n' "$1" "$(sha256sum <"$page" | cut -c 1-64)"; }

# is_tested MADE_OF [ARGUMENTS of ctest]
is_tested() {
  local file
  file=$(tested_page "${@:2}")
  [[ -s $page && -s $file && $(<"$file") == "$(tested_now "$1")" ]]
}

# keep_tested MADE_OF [ARGUMENTS of ctest]: for the next time, unless something changed while they ran.
keep_tested() {
  [[ $(made_of_page) == "$1" ]] || return 0
  tested_now "$1" >"$(tested_page "${@:2}")"
}
