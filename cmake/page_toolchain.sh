# What builds the page: Emscripten, in a Debian 13 of its own, because Debian 12's knows too little of C++20. apt checks
# the signatures of all that is in it. Sourced by ./web, after setup.sh; needs root, as installing packages does.

debian=trixie
downloads=$root/build/downloads

# Another list of packages is another toolchain, and an old one is never mistaken for it.
page_packages() { packages_of page; }
toolchain=$downloads/page-toolchain-$(page_packages | sha256sum | cut -c 1-12)

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || fail "The compiler of the page lives in a Debian 13 of its own, which only root can make and enter."
  as_root=(sudo)
fi

make_page_toolchain() {
  can_enter_page_toolchain || fail "This machine lets nobody mount a folder (unshare --mount), which building the page needs."
  local lock
  mkdir -p "$root/build"
  exec {lock}>"$root/build/.lock"
  flock "$lock"
  [[ -e $toolchain ]] || unpack_page_toolchain
  exec {lock}>&-
}

unpack_page_toolchain() {
  say "Making the page's toolchain, a Debian 13 in $toolchain (about 3 GB)"
  local scratch=$toolchain.part packages
  "${as_root[@]}" rm -rf --one-file-system "$scratch"
  mkdir -p "$downloads"
  packages=$(page_packages | paste -sd,)
  logged toolchain "${as_root[@]}" mmdebstrap --mode=root --variant=apt \
    --aptopt='APT::Install-Recommends "false"' --include="$packages" \
    "$debian" "$scratch" || fail_with toolchain "The page's toolchain could not be made."
  "${as_root[@]}" mv -T "$scratch" "$toolchain"
}

# ImGui and ImPlot, of the versions that the desktop has, as sources. pip asks a source package's own build system how it
# is called; a stand-in answers, so that nothing is run that nobody has checked.
fetch_imgui_sources() {
  local requirements=$root/cmake/imgui-sources-requirements.txt version scratch
  version=$(sed -n 's/^imgui-bundle==\([0-9.]*\).*/\1/p' "$requirements")
  [[ ! -e $downloads/imgui_bundle-$version.tar.gz ]] || return 0
  say "Fetching the sources of Dear ImGui and ImPlot"
  scratch=$(mktemp --directory)
  mkdir "$scratch/scikit_build_core"
  cat >"$scratch/scikit_build_core/build.py" <<END
import pathlib
def prepare_metadata_for_build_wheel(folder, settings=None):
    info = pathlib.Path(folder, "imgui_bundle-$version.dist-info")
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: imgui-bundle\nVersion: $version\n")
    return info.name
END
  logged imgui-sources env PYTHONPATH="$scratch" /usr/bin/python3 -m pip download --quiet --disable-pip-version-check \
    --require-hashes --no-deps --no-build-isolation --no-binary=imgui-bundle --dest "$scratch" \
    --requirement "$requirements" || fail_with imgui-sources "Dear ImGui could not be fetched."
  mv "$scratch/imgui_bundle-$version.tar.gz" "$downloads/"
  rm -rf "$scratch"
}

# Some machines, such as containers without rights, let nobody enter another system.
can_enter_page_toolchain() { "${as_root[@]}" unshare --mount --propagation private true 2>/dev/null; }

# in_page_toolchain COMMAND...: runs it there as the present user, with the checkout where it is here. The mount is seen
# by this command only, and ends with it.
in_page_toolchain() {
  local inside=(--ignore-environment PATH=/usr/bin:/bin LANG=C.UTF-8 HOME=/tmp EMCC_SKIP_SANITY_CHECK=1)
  "${as_root[@]}" mkdir -p "$toolchain$root"
  "${as_root[@]}" unshare --mount --propagation private bash -c 'mount --bind "$1" "$2$1" && exec chroot --userspec="$3" "$2" "${@:4}"' \
    bash "$root" "$toolchain" "$(id -u):$(id -g)" /usr/bin/env --chdir="$root" "${inside[@]}" "$@"
}

# As build(), with the CMake and the Ninja that are there.
build_in_page_toolchain() {
  cmake() { in_page_toolchain cmake "$@"; }
  ninja() { in_page_toolchain ninja "$@"; }
  build "$@"
  unset -f cmake ninja
}
