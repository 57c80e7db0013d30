"""changelog.py CHANGELOG.md MAINTAINER: prints the released versions of it in the form of a Debian changelog."""

import datetime
import re
import sys
import textwrap
from pathlib import Path


def entry(version: str, date: str, words: str, maintainer: str) -> str:
    points = [re.sub(r"\s+", " ", point) for point in re.findall(r"^- (.+(?:\n  .+)*)", words, re.MULTILINE)]
    lines = [textwrap.fill(point, 79, initial_indent="  * ", subsequent_indent="    ") for point in points]
    day = datetime.date.fromisoformat(date).strftime("%a, %d %b %Y")
    return (
        f"ghostforce ({version}) unstable; urgency=medium\n\n"
        + "\n".join(lines or ["  * Released."])
        + f"\n\n -- {maintainer}  {day} 00:00:00 +0000\n"
    )


def main() -> None:
    text = Path(sys.argv[1]).read_text(encoding="utf-8")
    releases = re.findall(r"^## \[(\d[^]]*)\] - (\d{4}-\d\d-\d\d)\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    if not releases:
        raise SystemExit("CHANGELOG.md has no line such as '## [0.2.0] - 2026-11-23'")
    sys.stdout.write("\n".join(entry(*release, sys.argv[2]) for release in releases))


main()
