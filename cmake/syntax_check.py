#!/usr/bin/env python3
"""Has the compiler read sources as a build would compile them, and makes nothing: it tells of errors and warnings only.

    cmake/syntax_check.py build/clang [SOURCE...]
    cmake/syntax_check.py build/clang-batches --but-of build/asan TARGET...

SOURCE is a path from the checkout's root. Those that this build does not compile are left out, and counted. Without any,
all that the build compiles of our own code are read. --but-of names another build by the same compiler, with the same
warnings, and targets of it: where these are up to date, what they are made of is left out. What the compiler says of a
source stands in one piece, below "FAILED: " and the source's path. Ends with 1 if it says anything.

What most sources include from outside is read once for all of them, which takes half the time. So a source that lacks
one of these includes is not found out; a build of the preset clang does that (.ci/long).
"""
import argparse
import concurrent.futures
import functools
import json
import os
import pathlib
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
OFTEN_INCLUDED = """
algorithm array atomic chrono cmath cstdint filesystem fstream functional map memory numbers optional random set span
sstream string string_view thread type_traits variant vector
fmt/format.h glm/glm.hpp gtest/gtest.h CLI/CLI.hpp nlohmann/json.hpp
""".split()
# As all say who define them at all; elsewhere they change nothing.
DEFINITIONS = ["-DFMT_SHARED", "-DGTEST_HAS_PTHREAD=1"]
FEW = 8  # for these alone it would not pay


def run(words, folder):
    """What the compiler says; empty where all is well."""
    answer = subprocess.run(
        words, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        check=False,
    )  # fmt: skip
    return answer.stdout or (f"It ended with {answer.returncode}.\n" if answer.returncode else "")


def reading(command):
    """The command of a build without its cache, and without what it writes."""
    words = iter(shlex.split(command))
    kept = []
    for word in words:
        if word == "-o":
            next(words)
        elif word == "-c":
            kept.append("-fsyntax-only")
        elif kept or pathlib.PurePath(word).name != "ccache":
            kept.append(word)
    return kept


def read_often_included(entry):
    """The options by which sources share what has been read; none where the compiler cannot, and they do without."""
    compiler, *options = reading(entry["command"])
    header = pathlib.Path(entry["directory"]) / "often_included.h"
    header.write_text("".join(f"#include <{each}>\n" for each in OFTEN_INCLUDED), encoding="utf-8")
    kept = [each for each in options if each.startswith(("-O", "-f", "-std=")) and each != "-fsyntax-only"]
    made = header.with_suffix(".pch")
    words = [compiler, *kept, *DEFINITIONS, "-fpch-instantiate-templates", "-x", "c++-header", header, "-o", made]
    return [] if run(words, entry["directory"]) else ["-include-pch", str(made)]


def read(shared, entry):
    words, folder = reading(entry["command"]), entry["directory"]
    # Whatever it says of the shared part, the source by itself has the last word.
    return run(words, folder) if not shared or run(words + shared, folder) else ""


def is_own(source):
    """Not what others have written, which is downloaded or made by the build. Batches are made by it, too."""
    path = pathlib.Path(source)
    return path.suffix == ".cpp" and not {"downloads", "generated"} & set(path.relative_to(ROOT).parts)


def entries_of(build):
    return json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))


def object_of(entry):
    """What it is compiled to, as a path in its build."""
    words = shlex.split(entry["command"])
    return pathlib.Path(words[words.index("-o") + 1])


def objects_of(build, *targets):
    """Paths in the build; none where ninja would still make some of them, or cannot say."""

    def ninja(*words):
        return run(["ninja", *words, *targets], build)

    return set(map(pathlib.Path, ninja("-t", "inputs").splitlines())) if "no work to do" in ninja("-n") else set()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("sources", nargs="*")
    parser.add_argument("--but-of", nargs="+", default=[])
    arguments = parser.parse_args()
    wanted = {str(ROOT / each) for each in arguments.sources}
    compiled = objects_of(*arguments.but_of) if arguments.but_of else set()
    entries = [
        each
        for each in entries_of(arguments.build)
        if (each["file"] in wanted if wanted else is_own(each["file"])) and object_of(each) not in compiled
    ]
    shared = read_often_included(entries[0]) if len(entries) > FEW else []
    has_failed = False
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for entry, words in zip(entries, pool.map(functools.partial(read, shared), entries)):
            if words:
                has_failed = True
                print(f"FAILED: {pathlib.Path(entry['file']).relative_to(ROOT)}\n{words}", flush=True)
    found = {each["file"] for each in entries}
    print(f"{len(found)} sources read, {len(wanted - found)} left out, which this build does not compile")
    return 1 if has_failed else 0


if __name__ == "__main__":
    sys.exit(main())
