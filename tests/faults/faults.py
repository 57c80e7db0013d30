"""Do the tests still find faults? Puts small ones into the program, one at a time, and runs the tests: for hours.

  faults.py [--only 7,9] [--tree FOLDER] [--no-build] [--limit SECONDS]

faults.toml beside this script lists them. One build has them all, of a copy of the tracked files under build/:
GHOSTFORCE_FAULT=7 in the environment chooses one when a program starts, and without it there is none. For each fault
a line says what has found it: a test that fails, or that does not end.

--only      these faults
--tree      another checkout, such as one of an older commit; a fault whose text it does not have is left out
--no-build  the build of the last time: neither the checkout nor the list has changed
--limit     for how long the tests may run with a fault; usually three times what they take without one
"""
import argparse
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
import zlib

root = pathlib.Path(__file__).resolve().parents[2]
COSTS = "CTestCostData.txt"  # of ctest: how long each test took, and after a line --- the names of those that failed

# Before the first line of a file with a fault. The environment is asked before main(): later some threads may not.
CHOICE = """\
#ifndef GHOSTFORCE_FAULTS
#define GHOSTFORCE_FAULTS
#include <cstdlib>
inline const char* const ghostforce_fault_asked_for = std::getenv("GHOSTFORCE_FAULT");
inline const int ghostforce_fault_chosen = ghostforce_fault_asked_for ? std::atoi(ghostforce_fault_asked_for) : 0;
inline bool ghostforce_fault(int number) noexcept { return number == ghostforce_fault_chosen; }
#endif
"""


def both(fault):
    """What stands in the place of the original text: that and the faulty one, of which one counts."""
    form = "if ({}) {{ {} }} else {{ {} }}" if fault["original"].endswith(";") else "({} ? ({}) : ({}))"
    return form.format(f"ghostforce_fault({fault['number']})", fault["faulty"], fault["original"])


def put_into(tree, copy, faults):
    """Copies the tracked files of the tree, and puts into them those of the faults that it can have."""
    shutil.rmtree(copy, ignore_errors=True)
    names = subprocess.run(["git", "-C", tree, "ls-files", "-z"], check=True, stdout=subprocess.PIPE, text=True).stdout
    for name in filter(None, names.split("\0")):
        (copy / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(tree / name, copy / name, follow_symlinks=False)
    # Not copied: what builds the page lies there too, a whole system with its devices, which would be read for ever.
    if (tree / "build/downloads").exists():  # so that nothing is fetched again
        (copy / "build").mkdir()
        (copy / "build/downloads").symlink_to(tree / "build/downloads")
    for fault in filter(lambda fault: is_in(tree, fault), faults):
        text = (copy / fault["file"]).read_text().replace(fault["original"], both(fault))
        (copy / fault["file"]).write_text(text if text.startswith(CHOICE) else CHOICE + text)


def is_in(tree, fault):
    path = tree / fault["file"]
    return path.exists() and path.read_text().count(fault["original"]) == 1


def build(copy):
    log = copy / "build/faults.log"
    log.parent.mkdir(exist_ok=True)
    words = "source cmake/setup.sh; use_ccache; cmake --preset release -DBUILD_TESTING=ON && ninja -C build/release all"
    with log.open("w") as out:
        done = subprocess.run(["bash", "-c", words], cwd=copy, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
    if done.returncode != 0:
        errors = re.findall(r"^.*(?:error: |CMake Error).*$", log.read_text(), re.MULTILINE)
        sys.exit("\n".join(errors[:10] + [f"The tree with the faults could not be built. All of it is in {log}."]))


def slots(copy):
    """Of ctest: three for each processor where most tests count as two, as run_tests has it in cmake/setup.sh."""
    return len(os.sched_getaffinity(0)) * (3 if (copy / "cmake/count_tests.awk").exists() else 1)


def run_tests(copy, number, first=(), limit=None):
    """Returns what has found the fault, empty if nothing has, and how long it took [s]."""
    results, status = copy / "build/release/Testing/Temporary", None
    shutil.rmtree(results, ignore_errors=True)
    os.makedirs(results)
    (results / COSTS).write_text("\n".join(["---", *first, ""]))  # as if these had failed: ctest begins with them
    words = ["ctest", "--test-dir", copy / "build/release", "--parallel", str(slots(copy)),
             "--stop-on-failure", "--no-tests=error", "--label-exclude", "^long$"]  # as ./check leaves them out
    began = time.monotonic()
    environment = {**os.environ, "GHOSTFORCE_FAULT": number, "GTEST_FAIL_FAST": "1"}
    with subprocess.Popen(words, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL, start_new_session=True) as ctest:
        try:
            status = ctest.wait(limit)
        except subprocess.TimeoutExpired:
            pass
        finally:
            if ctest.poll() is None:
                os.killpg(ctest.pid, signal.SIGKILL)  # with all tests
    seconds = time.monotonic() - began
    if status is None:
        return f"the time limit of {limit:.0f} s", seconds
    failed = results / "LastTestsFailed.log"
    if status == 0 or not failed.exists():
        return f"ctest, which ended with {status}" if status else "", seconds
    finders = ", ".join(line.partition(":")[2] for line in failed.read_text().splitlines())
    log = (results / "LastTest.log").read_text(errors="replace")
    test = re.search(r"^\[  FAILED  \] ([^\s,]+)", log, re.MULTILINE)
    return f"{finders} ({test[1]})" if test else finders, seconds


def seconds_of_tests(copy):
    """Of each test, by the run before."""
    costs = (copy / "build/release/Testing/Temporary" / COSTS).read_text().partition("---")[0]
    return {line.split()[0]: float(line.split()[-1]) for line in costs.splitlines()}


def likely_finders(seconds, fault):
    """Those of its folder, and quick ones: a fault that one of them finds need not wait for those that take minutes."""
    folder = os.path.dirname(fault["file"]).replace("/", "_") + "_"
    return [name for name in seconds if name.startswith(folder) or seconds[name] < 5.0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", metavar="NUMBERS", help="such as 7,9")
    parser.add_argument("--tree", metavar="FOLDER", type=pathlib.Path, default=root)
    parser.add_argument("--no-build", action="store_true")
    parser.add_argument("--limit", metavar="SECONDS", type=float)
    options = parser.parse_args()
    faults = tomllib.loads(pathlib.Path(__file__).with_name("faults.toml").read_text())["fault"]
    tree = options.tree.resolve()
    if not (tree / "cmake/setup.sh").exists():
        sys.exit(f"{tree} is no checkout of ghostforce; name the folder that has cmake and tests in it.")
    wanted = options.only.split(",") if options.only else [str(fault["number"]) for fault in faults]
    if unknown := set(wanted) - {str(fault["number"]) for fault in faults}:
        sys.exit(f"There is no fault {', '.join(sorted(unknown))}; the list has 1 to {len(faults)}.")
    copy = root / "build" / f"faults-{tree.name}-{zlib.crc32(bytes(tree)):08x}"
    if not options.no_build:
        print(f"Building {copy}", flush=True)
        put_into(tree, copy, faults)
        build(copy)
    elif not (copy / "build/release/build.ninja").exists():
        sys.exit(f"Nothing has been built in {copy} yet; leave out --no-build.")
    problem, seconds = run_tests(copy, "0")
    if problem:
        sys.exit(f"Without any fault the tests fail, and so they can find none: {problem}.")
    print(f"No fault: all tests pass, {seconds:.0f} s", flush=True)
    seconds_of, limit = seconds_of_tests(copy), options.limit or 3 * seconds
    found = tried = 0
    for fault in (fault for fault in faults if str(fault["number"]) in wanted):
        name = f"{fault['number']:2}  {fault['file']}"
        if not is_in(tree, fault):
            print(f"{name}  is left out: the file does not have its text once")
            continue
        finders, seconds = run_tests(copy, str(fault["number"]), likely_finders(seconds_of, fault), limit)
        tried, found = tried + 1, found + bool(finders)
        print(f"{name}  {f'found by {finders}' if finders else 'NOT FOUND'}, {seconds:.0f} s", flush=True)
    print(f"{found} of {tried} found")


if __name__ == "__main__":
    main()
