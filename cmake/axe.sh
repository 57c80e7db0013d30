# axe-core, for the tests of the page: from the wheel pinned in axe-requirements.txt, into build/downloads. Another pin
# is another file. Sourced by ./check after setup.sh.

axe=$root/build/downloads/axe-$(sha256sum <"$root/cmake/axe-requirements.txt" | cut -c 1-12).js

fetch_axe() {
  local scratch
  [[ ! -e $axe ]] || return 0
  say "Fetching axe-core"
  scratch=$(mktemp --directory)
  logged axe /usr/bin/python3 -m pip download --quiet --disable-pip-version-check --require-hashes --no-deps \
    --only-binary=:all: --python-version 3.12 --dest "$scratch" --requirement "$root/cmake/axe-requirements.txt" ||
    fail_with axe "axe-core could not be fetched."
  mkdir -p "${axe%/*}"
  /usr/bin/python3 -c 'import sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as wheel: sys.stdout.buffer.write(wheel.read("axe_playwright_python/axe.min.js"))' \
    "$scratch"/*.whl >"$axe.part"
  mv "$axe.part" "$axe"
  rm -rf "$scratch"
}
