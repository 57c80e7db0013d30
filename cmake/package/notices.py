"""What THIRD_PARTY_NOTICES.md says of the desktop program: the works in it, and the texts of their licences."""

import re
from typing import NamedTuple


class Work(NamedTuple):
    name: str
    part: str  # what of it is in the program
    licence: str
    copyright: str


def works(notices: str) -> list[Work]:
    """The rows of the desktop program's table."""
    section = notices.split("\n## In the desktop program\n")[1].split("\n## ")[0]
    rows = re.findall(r"^\| (.+) \|$", section, re.MULTILINE)[2:]
    return [Work(*(cell.strip() for cell in row.split(" | "))) for row in rows]


def licence_text(notices: str, licence: str) -> str:
    """The words under the heading of this licence."""
    text = re.search(rf"^## {re.escape(licence)}\n\n```\n(.*?)\n```$", notices, re.MULTILINE | re.DOTALL)
    if not text:
        raise SystemExit(f"THIRD_PARTY_NOTICES.md has no section '## {licence}' with the licence's text")
    return text[1]
