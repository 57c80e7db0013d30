"""The worked examples of CONTRIBUTING.md: what they add and change, and the commands that show it.

  examples.py apply TREE           adds and changes files in TREE, which must be as the examples found it
  examples.py files                prints the C++ files that the examples add or change
  examples.py run PROGRAM FOLDER   runs in FOLDER the commands that need a built PROGRAM, which knows the examples

An example is a section with the heading "### A ...". Each of its blocks has a line above it that says what it is:

  **New file** `PATH`:
  **In** `PATH`, after the line with `TEXT`:      or "before", or "instead of"; one line of the file has that text
  **Run** without building:                       commands that need no more than the new files
  **Run**:                                        commands of the program, once it is built

A command stands behind "$ "; the lines after it are what it prints, on either output, with "…" for any text, or any
lines.
"""
import dataclasses
import os
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]
document = root / "CONTRIBUTING.md"

code_span = r"(?:`` ?(.+?) ?``|`([^`]+)`)"
new_file = re.compile(rf"\*\*New file\*\* {code_span}:$")
change = re.compile(rf"\*\*In\*\* {code_span}, (after|before|instead of) the line with {code_span}:$")
run_at_once, run_when_built = "**Run** without building:", "**Run**:"


class Wrong(Exception):
    """An example that cannot be followed; says why."""


@dataclasses.dataclass
class Edit:
    path: str
    text: str
    place: str = ""  # after, before, instead of; empty: a new file
    anchor: str = ""

    def applied_to(self, files):
        """Changes `files`, which has a text for each path that has been read, and None for one that is not there."""
        found = files[self.path]
        if not self.place:
            if found is not None:
                raise Wrong(f"{self.path} is there already")
            files[self.path] = self.text
            return
        if found is None:
            raise Wrong(f"there is no {self.path}")
        lines = found.splitlines(keepends=True)
        at = [number for number, line in enumerate(lines) if self.anchor in line]
        if len(at) != 1:
            raise Wrong(f"{self.path} has {len(at)} lines with {self.anchor}; it should be one")
        first = at[0] + (self.place == "after")
        lines[first:at[0] + (self.place != "before")] = [self.text]
        files[self.path] = "".join(lines)


@dataclasses.dataclass
class Command:
    words: str
    expected: str  # with … for what may be anything
    is_built: bool

    def run(self, program, folder):
        path = f"{pathlib.Path(program).resolve().parent}:{os.environ['PATH']}"
        done = subprocess.run(["bash", "-c", self.words], cwd=folder, env={**os.environ, "PATH": path}, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if done.returncode != 0 or not matches(self.expected, done.stdout):
            raise Wrong(f"{self.words}\nends with {done.returncode} and prints\n{done.stdout}but should print\n"
                        f"{self.expected}")


@dataclasses.dataclass
class Example:
    title: str
    edits: list = dataclasses.field(default_factory=list)
    commands: list = dataclasses.field(default_factory=list)


def matches(expected, printed):
    pattern = "".join(r"(?:.*\n)*" if line == "…\n" else re.escape(line).replace("…", ".*")
                      for line in expected.splitlines(keepends=True))
    return re.fullmatch(pattern, printed) is not None


def commands_in(text, is_built):
    for part in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
        words, _, expected = part.partition("\n")
        yield Command(words, expected, is_built)


def read_examples(text):
    examples = []
    example = heading = fence = None
    for number, line in enumerate(text.splitlines(), 1):
        if fence is not None:
            if line != "```":
                fence += line + "\n"
                continue
            said, block, fence = heading or "", fence, None
            if said.startswith("**Run**"):
                example.commands += commands_in(block, said == run_when_built)
            elif found := new_file.match(said):
                example.edits.append(Edit(found[1] or found[2], block))
            elif found := change.match(said):
                example.edits.append(Edit(found[1] or found[2], block, found[3], found[4] or found[5]))
            heading = None
        elif line.startswith("```"):
            fence = ""
            if example and not heading:
                raise Wrong(f"line {number}: nothing says what this block is")
        elif line.startswith("#"):
            example = Example(line[4:]) if line.startswith("### A") else None
            if example:
                examples.append(example)
        elif line.startswith("**"):
            heading = line
            known = line in (run_at_once, run_when_built) or new_file.match(line) or change.match(line)
            if example and not known:
                raise Wrong(f"line {number}: not one of the lines that say what a block is: {line}")
    return examples


class Files(dict):
    """The files of a tree, read when they are asked for. What is changed here is not written."""

    def __init__(self, tree):
        super().__init__()
        self.tree = pathlib.Path(tree)

    def __missing__(self, path):
        file = self.tree / path
        self[path] = file.read_text(encoding="utf-8") if file.is_file() else None
        return self[path]

    def write(self, folder):
        for path, text in self.items():
            if text is None:
                continue
            file = pathlib.Path(folder) / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")


def follow(examples, tree):
    files = Files(tree)
    for example in examples:
        for edit in example.edits:
            try:
                edit.applied_to(files)
            except Wrong as wrong:
                raise Wrong(f"{example.title}: {wrong}") from None
    return files


def main(words):
    examples = read_examples(document.read_text(encoding="utf-8"))
    match words:
        case ["apply", tree]:
            follow(examples, tree).write(tree)
        case ["files"]:
            paths = {edit.path for example in examples for edit in example.edits}
            print("\n".join(sorted(path for path in paths if path.endswith((".cpp", ".h")))))
        case ["run", program, folder]:
            for command in (each for example in examples for each in example.commands if each.is_built):
                print(f"$ {command.words}", flush=True)
                command.run(program, folder)
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Wrong as problem:
        sys.exit(f"CONTRIBUTING.md: {problem}")
