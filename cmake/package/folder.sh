#!/usr/bin/env bash
# bash folder.sh TREE: makes ghostforce-VERSION-MACHINE.tar.zst in the build tree: a folder that can be unpacked anywhere,
# with the libraries that a plain desktop, or a server without one, may lack. Called by ./package.
#
# The system's C and C++ libraries and its graphics are never in it: drivers belong to the machine. Of the others,
# those with a C++ interface are ours, because only the very version fits; of those with a C interface the system's goes
# first, because what the desktop itself loads into the program (GTK for a window's frame) fits its own, and because
# it is kept secure; ours, in lib/fallback, stand in for what is missing.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../setup.sh"

tree=$1
from_cache() { sed -n "s/^$1:[A-Z]*=//p" "$tree/CMakeCache.txt"; }
version=$(from_cache CMAKE_PROJECT_VERSION)
machine=$(uname -m)
name=ghostforce-$version-$machine
folder=$tree/$name
libraries=$(gcc -print-multiarch)  # Debian's folder of them
python=$(from_cache GHOSTFORCE_PYTHON)

rm -rf "$folder"
umask 022
logged folder cmake --install "$tree" --prefix "$folder" --strip || fail_with folder "The folder could not be filled."

# ---- Libraries -------------------------------------------------------------------------------------------------------

mkdir -p "$folder/lib/fallback"
while read -r library path; do
  case $library in
    libfmt.* | libtomlplusplus.*) place=lib ;;
    libc.* | libm.* | libpthread.* | libgcc_s.* | libstdc++.* | libz.*) continue ;;
    libudev.*) continue ;;
    *) place=lib/fallback ;;
  esac
  install -m 644 -t "$folder/$place" "$path"
  package=$(dpkg-query --search "*/$libraries/$(basename "$(realpath "$path")")" | head -n 1)
  package=${package%%:*}
  install -D -m 644 "/usr/share/doc/$package/copyright" "$folder/share/doc/ghostforce/libraries/$package"
done < <(ldd "$folder/bin/ghostforce" | awk '$2 == "=>" { print $1, $3 }')

system=/usr/lib/$libraries:/usr/lib64
patchelf --set-rpath "\$ORIGIN/../lib:$system:\$ORIGIN/../lib/fallback" "$folder/bin/ghostforce"
patchelf --set-rpath "$system:\$ORIGIN" "$folder"/lib/fallback/*

# ---- What it needs of the system, and what it is made of -------------------------------------------------------------

# newest PREFIX: the newest of these versions of symbols that anything in the folder asks for.
newest() {
  objdump --dynamic-syms "$folder/bin/ghostforce" "$folder"/libexec/ghostforce/* "$folder"/lib/*.so* \
    "$folder"/lib/fallback/* |
    sed -n "s/.*(\?$1_\([0-9.]*\))\?.*/\1/p" | sort --version-sort | tail -n 1
}
# Those of Debian 12 and its contemporaries: glibc 2.36, and the C++ library of GCC 12.
for limit in GLIBC:2.36 GLIBCXX:3.4.30; do
  found=$(newest "${limit%:*}")
  [[ $(printf '%s\n' "$found" "${limit#*:}" | sort --version-sort | tail -n 1) == "${limit#*:}" ]] ||
    fail "The folder would need ${limit%:*} $found, but must run where there is ${limit#*:}. Make it on Debian 12."
done

bill=$folder/share/doc/ghostforce/ghostforce.cdx.json
"$python" -B "$root/cmake/package/sbom.py" @"$tree/sbom-options.txt" \
  "$folder/bin/ghostforce" "$folder"/lib/*.so* "$folder"/lib/fallback/* >"$bill"

# ---- The archive -----------------------------------------------------------------------------------------------------

tar --create --sort=name --format=gnu --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" \
  --directory "$tree" "$name" | zstd -19 --threads=1 --quiet --force -o "$folder.tar.zst"
rm -rf "$folder"
