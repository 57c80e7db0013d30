#!/usr/bin/env bash
# bash tests/package/same_bytes.sh: makes the packages of this commit once more, in a clone of another name, without
# ccache, and compares them with those that ./package has made here of the same commit.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../cmake/setup.sh"

scratch=$(mktemp --directory)
trap 'rm -rf "$scratch"' EXIT
clone="$scratch/another place"
git clone --quiet --no-local --depth=1 "file://$root" "$clone"
mkdir -p "$clone/build/downloads"
cp -r "$root"/build/downloads/imgui-* "$clone/build/downloads/" || true  # where it is there, it is not fetched again
logged same-bytes env --unset=CMAKE_C_COMPILER_LAUNCHER --unset=CMAKE_CXX_COMPILER_LAUNCHER "$clone/package" ||
  fail_with same-bytes "The packages could not be made a second time."

for made in "$clone"/build/package/*.deb "$clone"/build/package/*.tar.zst; do
  cmp "$made" "$root/build/package/$(basename "$made")" || fail "$(basename "$made") is not the same when it is made again."
  say "$(sha256sum <"$made" | cut -d' ' -f1)  $(basename "$made"), both times"
done
