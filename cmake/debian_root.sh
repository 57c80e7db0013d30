# Other Debian systems, each in a folder ("root") of its own: made by mmdebstrap, entered by chroot. apt checks the
# signatures of all that is in them. Sourced after setup.sh; making and entering one needs root, as installing packages
# does.

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || fail "This needs a Debian in a folder of its own, which only root can make and enter."
  as_root=(sudo)
fi

# Some machines, such as containers without rights, let nobody enter another system.
can_enter_debian_root() {
  "${as_root[@]}" unshare --mount --propagation private --pid --fork mount -t proc proc /proc 2>/dev/null
}

# make_debian_root FOLDER SUITE [ARGUMENTS of mmdebstrap]: makes it where it is not there yet. Whoever ends this halfway
# leaves FOLDER.part only, and the next call starts anew.
make_debian_root() {
  local folder=$1 suite=$2 scratch=$1.part log lock
  can_enter_debian_root ||
    fail "This machine lets nobody mount a folder (unshare --mount --pid), which entering $folder needs."
  mkdir -p "$(dirname "$folder")" "$root/build"
  exec {lock}>"$folder.lock"  # its own: this machine may build meanwhile
  flock "$lock"
  if [[ ! -e $folder ]]; then
    install_packages roots
    say "Making a Debian system ($suite) in $folder"
    log=$(basename "$folder")
    "${as_root[@]}" rm -rf --one-file-system "$scratch"
    # With the certificates that this machine's network wants trusted: the package ca-certificates takes them from there.
    # What it mounts ends with it, even where it is killed; else the next call could not remove $scratch.
    logged "$log" "${as_root[@]}" unshare --mount --propagation private mmdebstrap --mode=root --aptopt='APT::Install-Recommends "false"' \
      --essential-hook='cp -r /usr/local/share/ca-certificates "$1/usr/local/share/" || true' "${@:3}" \
      "$suite" "$scratch" || fail_with "$log" "The Debian system could not be made."
    "${as_root[@]}" mv -T "$scratch" "$folder"
  fi
  exec {lock}>&-
}

# in_debian_root FOLDER [--user ID:GROUP] [--mount HERE:THERE]... [NAME=VALUE]... COMMAND...: runs it there, as root or
# as this user, with this machine's network and devices, and with the folders HERE at THERE. The mounts and all processes
# are seen by this command only, and end with it.
in_debian_root() {
  local folder=$1 user='' mounts=()
  shift
  while [[ $1 == --user || $1 == --mount ]]; do
    if [[ $1 == --user ]]; then user=$2; else mounts+=("$2"); fi
    shift 2
  done
  "${as_root[@]}" unshare --mount --propagation private --pid --fork --kill-child bash -euc '
    folder=$1 user=$2 count=$3
    shift 3
    cp --dereference --remove-destination /etc/resolv.conf /etc/hosts "$folder/etc/"
    for name in dev sys; do mount --rbind "/$name" "$folder/$name"; done
    mount -t proc proc "$folder/proc"
    for ((; count; --count)); do
      mkdir -p "$folder${1#*:}"
      mount --rbind "${1%%:*}" "$folder${1#*:}"
      shift
    done
    # The first process of its namespace: signals that it does not expect are kept from it, and all others end with it.
    trap "exit 130" INT TERM
    chroot ${user:+--userspec="$user"} "$folder" /usr/bin/env --ignore-environment PATH=/usr/sbin:/usr/bin:/sbin:/bin \
      LANG=C.UTF-8 HOME=/tmp "$@" <&0 &
    wait $!' bash "$folder" "$user" "${#mounts[@]}" "${mounts[@]}" "$@"
}
