"""copyright.py LICENSE THIRD_PARTY_NOTICES.md: prints the copyright file of the Debian package, machine-readable.

Fonts have no place here: the package contains none, but depends on theirs.
"""

import re
import sys
from pathlib import Path

import notices

# Of two licences, the one that we take.
TAKEN = {"MIT or public domain": "MIT", "WTFPL or CC0-1.0": "CC0-1.0"}
# Those whose text every Debian system has.
COMMON = "/usr/share/common-licenses/"
SHARED = ("Apache-2.0", "CC0-1.0")


def indented(text: str) -> str:
    return "\n".join(f" {line}" if line.strip() else " ." for line in text.split("\n"))


def main() -> None:
    own = Path(sys.argv[1]).read_text(encoding="utf-8")
    text = Path(sys.argv[2]).read_text(encoding="utf-8")
    works = [work for work in notices.works(text) if work.part != "font files"]

    paragraphs = [
        "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: ghostforce",
        f"Files: *\nCopyright: {re.search(r'^Copyright [(]c[)] (.+)$', own, re.MULTILINE)[1]}\nLicense: MIT",
    ]
    licences = ["MIT"]
    for work in works:
        folder = re.sub(r"[^a-z0-9]+", "-", work.name.lower()).strip("-")
        holders = re.sub(r"Copyright (\(c\) )?", "", work.copyright).split("; ")
        licence = TAKEN.get(work.licence, work.licence)
        paragraphs.append(
            f"Files: {folder}/*\nCopyright: {(chr(10) + ' ').join(holders)}\nLicense: {licence}\n"
            f"Comment: {work.name}: {work.part}."
        )
        licences.append(licence)
    for licence in dict.fromkeys(licences):
        is_shared = licence in SHARED
        words = f"The text is in {COMMON}{licence}." if is_shared else notices.licence_text(text, licence)
        paragraphs.append(f"License: {licence}\n{indented(words)}")
    sys.stdout.write("\n\n".join(paragraphs) + "\n")


main()
