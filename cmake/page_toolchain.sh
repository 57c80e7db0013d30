# What builds the page: Emscripten, in a Debian 13 of its own (about 3 GB), because Debian 12's knows too little of C++20.
# Sourced by ./web, after setup.sh and debian_root.sh.

downloads=$root/build/downloads

# Another list of packages is another toolchain, and an old one is never mistaken for it.
page_packages() { packages_of page; }
toolchain=$downloads/page-toolchain-$(page_packages | sha256sum | cut -c 1-12)

make_page_toolchain() {
  make_debian_root "$toolchain" trixie --variant=apt --include="$(page_packages | paste -sd,)"
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

# in_page_toolchain COMMAND...: runs it there as the present user, with the checkout where it is here.
in_page_toolchain() {
  in_debian_root "$toolchain" --user "$(id -u):$(id -g)" --mount "$root" EMCC_SKIP_SANITY_CHECK=1 \
    /usr/bin/env --chdir="$root" "$@"
}

# As build(), with the CMake and the Ninja that are there.
build_in_page_toolchain() {
  cmake() { in_page_toolchain cmake "$@"; }
  ninja() { in_page_toolchain ninja "$@"; }
  build "$@"
  unset -f cmake ninja
}
