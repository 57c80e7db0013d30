"""Prints what the program is made of, a software bill of materials, as CycloneDX 1.5 JSON.

  sbom.py --version VERSION --notices FILE --architecture NAME [--wheel FILE --headers FOLDER] FILE...
  sbom.py @OPTIONS FILE...

Named are the works that THIRD_PARTY_NOTICES.md says are in the program, and the shared libraries that the linker of
each FILE has asked for: the program, and libraries that are given away with it. --wheel, --headers: what pins Dear
ImGui, ImPlot and GLFW, and their headers, where they come from there. --architecture: Debian's folder of libraries,
such as x86_64-linux-gnu. Versions are those of the Debian packages of this machine; where there is no dpkg, they are
left out. The same input gives the same bytes: there is no serial number, and the only time is SOURCE_DATE_EPOCH.
"""

import argparse
import datetime
import json
import os
import platform
import re
import shutil
import subprocess
from pathlib import Path
from urllib.parse import quote

import notices

# Where works that are inside the program come from: a header of the wheel that says the version,
HEADERS = {
    "Dear ImGui": ("imgui.h", r'#define IMGUI_VERSION\s+"([\d.]+)'),
    "ImPlot": ("implot.h", r'#define IMPLOT_VERSION\s+"([\d.]+)'),
    "GLFW": ("GLFW/glfw3.h", r"GLFW ([\d.]+)"),
}
# or a Debian package.
PACKAGES = {
    "glad": "python3-glad",
    "OpenGL registry": "python3-glad",
    "khrplatform.h": "python3-glad",
    "GLM": "libglm-dev",
    "JSON for Modern C++": "nlohmann-json3-dev",
    "CLI11": "libcli11-dev",
    "DejaVu fonts": "fonts-dejavu-core",
}
# The words of THIRD_PARTY_NOTICES.md as SPDX expressions.
SPDX = {
    "Bitstream Vera": "Bitstream-Vera",
    "MIT or public domain": "MIT",
    "WTFPL or CC0-1.0": "WTFPL OR CC0-1.0",
    "zlib": "Zlib",
}
# The licences of the shared libraries, by the name before the numbers and ".so".
LIBRARY_LICENCES = {
    "ld-linux-aarch64": "LGPL-2.1-or-later",
    "ld-linux-x86-64": "LGPL-2.1-or-later",
    "libasan": "Apache-2.0 WITH LLVM-exception",
    "libubsan": "Apache-2.0 WITH LLVM-exception",
    "libX11": "X11",
    "libXext": "X11",
    "libXrender": "HPND-sell-variant",
    "libbrotlicommon": "MIT",
    "libbrotlidec": "MIT",
    "libc": "LGPL-2.1-or-later",
    "libcairo": "LGPL-2.1-only OR MPL-1.1",
    "libcrypto": "Apache-2.0",
    "libexpat": "MIT",
    "libfmt": "MIT",
    "libfontconfig": "HPND-sell-variant",
    "libfreetype": "FTL OR GPL-2.0-or-later",
    "libgcc_s": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "libhidapi-hidraw": "GPL-3.0-only OR BSD-3-Clause OR HIDAPI",
    "libm": "LGPL-2.1-or-later",
    "libpixman": "MIT",
    "libpng": "libpng-2.0",
    "libstdc++": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "libtomlplusplus": "MIT",
    "libudev": "LGPL-2.1-or-later",
    "libusb": "LGPL-2.1-or-later",
    "libxcb": "MIT-open-group",
    "libxcb-render": "MIT-open-group",
    "libxcb-shm": "MIT-open-group",
    "libz": "Zlib",
}


def output_of(*command: str) -> str:
    """Nothing where there is no such program, or it has no answer."""
    if not shutil.which(command[0]):
        return ""
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


class Debian:
    """Which packages of this machine have these libraries, and the versions of those and of PACKAGES; asked once."""

    def __init__(self, libraries: list[str], architecture: str):
        paths = [f"{place}/{architecture}/{library}" for library in libraries for place in ("/lib", "/usr/lib")]
        found = output_of("dpkg-query", "--search", *paths)
        self.owners = {path.rpartition("/")[2]: owner for owner, path in re.findall(r"^(\S+?)(?::\S+)?: (.+)$", found, re.M)}
        said = output_of(
            "dpkg-query", "--show", "--showformat", "${Package} ${Version} ${Architecture}\n",
            *sorted({*self.owners.values(), *PACKAGES.values()}),
        )
        self.versions = {name: rest for name, *rest in map(str.split, said.splitlines()) if len(rest) == 2}

    def origin(self, package: str | None) -> dict:
        """The version and purl of a package; empty: there is none."""
        if package not in self.versions:
            return {}
        version, architecture = self.versions[package]
        system = platform.freedesktop_os_release()
        place = f"arch={architecture}&distro={system['ID']}-{system.get('VERSION_ID', 'sid')}"
        purl = f"pkg:deb/{system['ID']}/{quote(package)}@{quote(version, safe='')}?{place}"
        return {"version": version, "purl": purl}


def component(name: str, licence: str | None, origin: dict, description: str) -> dict:
    result = {"type": "library", "bom-ref": name, "name": name} | origin | {"description": description}
    if licence:
        result["licenses"] = [{"expression": licence}]
    return result


def pinned(name: str, wheel: Path, headers: Path) -> dict:
    header, pattern = HEADERS[name]
    version = re.search(pattern, (headers / header).read_text(encoding="utf-8"))[1]
    package, pin = re.search(r"^([\w-]+)==(\S+)", wheel.read_text(encoding="utf-8"), re.MULTILINE).groups()
    return {"version": version, "purl": f"pkg:pypi/{package}@{pin}"}


def inside(work: notices.Work, debian: Debian, options: argparse.Namespace) -> dict:
    origin = {}
    if work.name in PACKAGES:
        origin = debian.origin(PACKAGES[work.name])
    elif work.name in HEADERS and options.wheel:
        origin = pinned(work.name, options.wheel, options.headers)
    return component(work.name, SPDX.get(work.licence, work.licence), origin, work.part)


def needed(files: list[str]) -> list[str]:
    said = subprocess.run(["readelf", "--dynamic", *files], capture_output=True, text=True, check=True).stdout
    return sorted(set(re.findall(r"\(NEEDED\).*\[(.+)\]", said)))


def linked(library: str, debian: Debian) -> dict:
    stem = re.sub(r"[-\d.]*\.so.*", "", library)
    return component(library, LIBRARY_LICENCES.get(stem), debian.origin(debian.owners.get(library)), "shared library")


def main() -> None:
    parser = argparse.ArgumentParser(fromfile_prefix_chars="@")
    parser.add_argument("--version", required=True)
    parser.add_argument("--notices", type=Path, required=True)
    parser.add_argument("--architecture", required=True)
    parser.add_argument("--wheel", type=Path)
    parser.add_argument("--headers", type=Path)
    parser.add_argument("files", nargs="+", metavar="FILE")
    options = parser.parse_args()

    works = notices.works(options.notices.read_text(encoding="utf-8"))
    libraries = needed(options.files)
    debian = Debian(libraries, options.architecture)
    components = [inside(work, debian, options) for work in works]
    components += [linked(library, debian) for library in libraries]
    metadata = {
        "component": {
            "type": "application",
            "bom-ref": "ghostforce",
            "name": "ghostforce",
            "version": options.version,
            "licenses": [{"expression": "MIT"}],
        }
    }
    if epoch := os.environ.get("SOURCE_DATE_EPOCH"):
        time = datetime.datetime.fromtimestamp(int(epoch), datetime.timezone.utc)
        metadata = {"timestamp": time.strftime("%Y-%m-%dT%H:%M:%SZ")} | metadata
    bill = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": metadata,
        "components": components,
        "dependencies": [{"ref": "ghostforce", "dependsOn": [each["bom-ref"] for each in components]}],
    }
    print(json.dumps(bill, indent=2, ensure_ascii=False))


main()
