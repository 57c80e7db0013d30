#!/usr/bin/env bash
# bash tests/package/in_root.sh: tries what ./package has made on systems that have nothing of it, and says what it does
# there: the Debian package in a bare Debian 12, up to its removal; the folder in Debian 12 and 13, with the libraries
# that a plain desktop has. Needs root and a network; the bare systems stay in build/roots for the next time.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../cmake/setup.sh"
source "$root/cmake/debian_root.sh"

made=("$root"/build/package/ghostforce_*.deb "$root"/build/package/ghostforce-*.tar.zst)
[[ -e ${made[0]} && -e ${made[1]} ]] || fail "There is nothing to try in build/package. ./package makes it."
deb=${made[0]} archive=${made[1]}
trial=$root/build/roots/trial

# fresh SUITE PACKAGE...: $trial becomes a bare system of it, with these packages.
fresh() {
  make_debian_root "$root/build/roots/$1" "$1" --variant=apt
  "${as_root[@]}" rm -rf --one-file-system "$trial"
  "${as_root[@]}" cp --archive --reflink=auto "$root/build/roots/$1" "$trial"
  apt_there update
  apt_there install mount passwd "${@:2}"
  in_trial useradd --create-home visitor
}

in_trial() { in_debian_root "$trial" LC_ALL=C DEBIAN_FRONTEND=noninteractive HOME=/home/visitor "$@"; }
apt_there() {
  logged trial in_trial apt-get --yes --no-install-recommends "$@" || fail_with trial "apt-get $1 failed in $trial."
}

# As somebody who has no rights, and with the folder $place, if there is one, read-only: a mount ends with its command.
place=
as_visitor() {
  in_trial bash -euc 'if [[ $0 ]]; then mount --bind "$0" "$0"; mount -o remount,bind,ro "$0"; fi
    cd /home/visitor; exec runuser --user visitor -- "$@"' "$place" "$@"
}

# unpack PLACE: the folder of programs there.
unpack() {
  place=$1
  "${as_root[@]}" mkdir -p "$trial$place"
  "${as_root[@]}" tar --extract --directory "$trial$place" --file "$archive"
  if as_visitor touch "$place/x" 2>/dev/null; then fail "$place can be written to."; fi
  program=$place/$(basename "$archive" .tar.zst)/bin/ghostforce
}

# try_out PROGRAM: the same for either way to install it.
try_out() {
  as_visitor "$1" --version
  as_visitor "$1" render wall45 -o x.png
  as_visitor test -s x.png
  as_visitor xvfb-run --auto-servernum "$1" run --exit-after 2
}

# All files but people's own and those in which apt, dpkg and the running system keep their books.
files() {
  local folder left_out=()
  for folder in proc sys dev run tmp home var/lib/apt var/lib/dpkg var/cache var/log; do
    left_out+=(-path "$trial/$folder" -prune -o)
  done
  "${as_root[@]}" find "$trial" -xdev "${left_out[@]}" -printf '%P\n' | sort
}

begin "the package in a bare Debian 12"
fresh bookworm xvfb xauth
before=$(files)
"${as_root[@]}" cp "$deb" "$trial/tmp/"
apt_there install "/tmp/$(basename "$deb")"
try_out ghostforce
in_trial test -s /usr/share/man/man1/ghostforce.1.gz
apt_there purge --autoremove ghostforce
diff <(printf '%s\n' "$before") <(files) || fail "Something of the package has stayed."
end

for suite in bookworm trixie; do
  begin "the folder in $suite, in a path with a space, read-only"
  mapfile -t desktop < <(packages_of run)
  fresh "$suite" xvfb xauth "${desktop[@]}"
  unpack "/opt/my programs"
  try_out "$program"
  end
done

begin "the folder on a server without a desktop"
fresh bookworm libosmesa6
unpack /opt/ghostforce
as_visitor "$program" simulate wall45 -o run.csv
as_visitor "$program" render wall45 -o x.png
as_visitor test -s x.png
as_visitor mkdir cases
as_visitor sh -c 'printf "scene = \"wall45\"\nsize = [320, 240]\n" >cases/a.toml'
as_visitor "$program" check cases --update a
as_visitor "$program" check cases
# What it says of the display that it cannot find is its own, not the loader's.
words=$(as_visitor "$program" run 2>&1) && fail "run has found a display."
grep "there is no display to open a window on" <<<"$words" || fail "run says: $words"
end
"${as_root[@]}" rm -rf --one-file-system "$trial"
