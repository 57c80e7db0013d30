#!/usr/bin/env python3
"""Prints the .cpp files that a change may have broken: those that differ from a commit, and those that include, at
however many steps, a file that does. What is not committed counts too.

    cmake/changed_sources.py [COMMIT]

Without COMMIT it is the newest commit of this branch that is at least a day older than the last one, by their dates.
What changed before that is read again by .ci/long only, which reads everything. Where there is no such commit, because
the history is short or this is a copy without any, all .cpp files are printed. What stands in CMakeLists.txt and the
like changes no source.
"""
import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDERS = ("app", "bench", "core", "device", "tests")
DAY_S = 24 * 60 * 60
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)


def git(*arguments):
    """What it says; None where there is no git, or where it fails."""
    try:
        answer = subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True, check=False)
    except OSError:
        return None
    return answer.stdout if answer.returncode == 0 else None


def is_checkout():
    """Whether the history is this folder's own, not that of one around it."""
    top = git("rev-parse", "--show-toplevel")
    return top is not None and pathlib.Path(top.rstrip("\n")) == ROOT


def commit_of_yesterday():
    date = git("log", "-1", "--format=%ct")
    if date is None:
        return None
    found = git("rev-list", "-1", "--first-parent", f"--before={int(date) - DAY_S}", "HEAD")
    return found.strip() or None if found is not None else None


def changed_since(commit):
    """Paths; None where git does not know."""
    tracked = git("diff", "--name-only", "--no-renames", "-z", commit, "--")
    new = git("ls-files", "--others", "--exclude-standard", "-z")
    return None if tracked is None or new is None else set(filter(None, (tracked + new).split("\0")))


def with_includers(changed, texts):
    """Includes are written from the root. One that is a mere name may mean any file of this name."""
    includers = collections.defaultdict(set)
    for path, text in texts.items():
        for included in INCLUDE.findall(text):
            includers[included].add(path)
    found, next_ones = set(), list(changed)
    while next_ones:
        path = next_ones.pop()
        if path not in found:
            found.add(path)
            next_ones += includers[path] | includers[pathlib.PurePath(path).name]
    return found


def main(arguments):
    if len(arguments) > 1:
        sys.exit(f"usage: {pathlib.Path(__file__).name} [COMMIT]")
    texts = {
        path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")
        for folder in FOLDERS
        for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in (".cpp", ".h")
    }
    found = None
    if is_checkout() and (commit := arguments[0] if arguments else commit_of_yesterday()):
        found = changed_since(commit)
    if found is None and arguments:
        sys.exit(f"{arguments[0]}: git knows no such commit here.")
    wanted = texts if found is None else with_includers(found, texts)
    for path in texts:
        if path.endswith(".cpp") and path in wanted:
            print(path)


if __name__ == "__main__":
    main(sys.argv[1:])
