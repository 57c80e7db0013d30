"""README.md and docs/: links lead somewhere, each guide is in the index, and commands are those that the program has.

GHOSTFORCE in the environment is the program.
"""
import os
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDES = sorted((ROOT / "docs").glob("*.md"))
PAGES = [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "ARCHITECTURE.md")] + GUIDES
LINK = re.compile(r"\]\(([^)\s]+)\)")
# In a block of code at the beginning of a line, elsewhere between backticks; what follows a comment is none of it.
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
WORDS = r"(?:\./demo|ghostforce)((?: [^\s`|#>]+)+)"
CALL_IN_BLOCK = re.compile(r"^ *(?:\$ )?(?:build/release/bin/)?" + WORDS, re.MULTILINE)
CALL_IN_TEXT = re.compile("`" + WORDS)
OPTION = re.compile(r"--[a-z][a-z-]*")
# What a reader can do where they read it: a line of a block, or a cell that begins a row of a table, once they have saved
# what they are told to. Other blocks hold data, or answers beside their commands, which that command's tests compare.
LINE = re.compile(r"^ *(?:\./demo|ghostforce)( [^#\n]+)", re.MULTILINE)
ROW = re.compile(r"^\| `(?:\./demo|ghostforce)( [^`]+)`", re.MULTILINE)
SAVED_AS = re.compile(r"as `([\w-]+\.toml)`[^`]*\Z")
# Commands that need a window, a device, a shell's loop, a tool that may be missing, or a file that the page does not
# make. sweep_test follows the pipes of sweep.md and compares what they print; check_lessons_test follows lessons.md.
NOT_HERE = re.compile(r"^ *(?:$|-|run\b|doctor\b)|[$|…*]|\.(?:mp4|webm)\b|\b(?:my[-_]lesson|visit|steep|from-a-browser)")
SCRIPT = re.compile(r"^ *(?:\$ )?(?:bash )?(\.?/?[\w./-]+)", re.MULTILINE)


def name_of(page):
    return page.relative_to(ROOT).as_posix()


def anchors(page):
    """As they are made of headings."""
    found = set()
    for heading in re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE):
        words = re.sub(r"[^\w\- ]", "", heading.lower())
        found.add(words.strip().replace(" ", "-"))
    return found


def calls(page):
    """The words of each call of a command: [render, wall45, -o, …]."""
    text = page.read_text(encoding="utf-8")
    blocks = "\n".join(block[2] for block in BLOCK.finditer(text))
    for found in CALL_IN_BLOCK.findall(blocks) + CALL_IN_TEXT.findall(BLOCK.sub("", text)):
        try:
            yield shlex.split(found)
        except ValueError:  # quotes that end on another line
            yield found.split()


class Reader:
    """Does what a page says, from its beginning to its end, in an empty folder: later lines read what earlier ones made."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.lines_done = 0
        programs = self.folder / "programs"
        programs.mkdir()
        (programs / "ghostforce").symlink_to(os.environ["GHOSTFORCE"])
        (self.folder / "docs").mkdir()  # where the pictures of the guides lie
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith("XDG_")}
        self.environment |= {"HOME": folder, "PATH": f"{programs}:{os.environ['PATH']}"}

    def follow(self, page):
        text = page.read_text(encoding="utf-8").replace("\\\n", " ")
        found = [*BLOCK.finditer(text), *ROW.finditer(text)]
        for each in sorted(found, key=lambda match: match.start()):
            if each.re is ROW:
                self.do(page, each[1])
            elif each[1] == "toml":
                if name := SAVED_AS.search(text[:each.start()]):
                    (self.folder / name[1]).write_text(each[2], encoding="utf-8")
            elif each[1] == "bash":
                self.run(page, re.sub(r"^xdg-open .*$", "", each[2], flags=re.MULTILINE))
            elif each[1] == "":
                for line in LINE.findall(each[2]):
                    self.do(page, line)

    def do(self, page, words):
        if NOT_HERE.search(words):
            return
        # Only check.md says how to make the reader's pictures.
        if "pictures" in words and not (self.folder / "pictures").exists():
            return
        self.run(page, "ghostforce" + words)
        if output := re.search(r" -o (\S+)", words):
            made = self.folder / output[1]
            if not made.exists() or (made.is_dir() and not any(made.iterdir())):
                raise AssertionError(f"{name_of(page)}: {words} has not made {output[1]}")

    def run(self, page, script):
        call = ["bash", "-e", "-c", script]
        answer = subprocess.run(call, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                                capture_output=True, text=True)
        if answer.returncode != 0:
            raise AssertionError(f"{name_of(page)}: {script}\n{answer.stderr}")
        self.lines_done += script.count("ghostforce ")


def said_by(*words):
    answer = subprocess.run([os.environ["GHOSTFORCE"], *words], capture_output=True, text=True, check=True)
    return answer.stdout


class Guides(unittest.TestCase):
    def test_commands_do_what_their_page_promises(self):
        lines_done = {}
        for page in PAGES[:1] + GUIDES:
            with tempfile.TemporaryDirectory(prefix="ghostforce-guide-") as folder:
                reader = Reader(folder)
                reader.follow(page)
                lines_done[name_of(page)] = reader.lines_done
        for page in ("README.md", "docs/check.md", "docs/commands.md", "docs/figures.md", "docs/scenes.md", "docs/teaching.md"):
            self.assertGreater(lines_done[page], 2, page)

    def test_the_policy_of_the_page_is_that_of_the_guide(self):
        page = (ROOT / "app/shell/web/page.html").read_text(encoding="utf-8")
        own = re.search(r'<meta http-equiv="Content-Security-Policy" content="([^"]+)">', page)[1]
        guide = (ROOT / "docs/web.md").read_text(encoding="utf-8")
        header = re.search(r"^Content-Security-Policy: (.*)$", guide, re.MULTILINE)[1]
        # Who may show the page inside another one only a header can say.
        self.assertEqual(own, header.partition("; frame-ancestors ")[0])

    def test_links_lead_somewhere(self):
        for page in PAGES:
            for link in LINK.findall(page.read_text(encoding="utf-8")):
                if re.match(r"[a-z]+:", link):
                    continue
                path, _, anchor = link.partition("#")
                target = (page.parent / path).resolve() if path else page
                with self.subTest(page=name_of(page), link=link):
                    self.assertTrue(target.exists())
                    if anchor:
                        self.assertIn(anchor, anchors(target))

    def test_each_guide_is_in_the_index(self):
        index = LINK.findall((ROOT / "docs/README.md").read_text(encoding="utf-8"))
        listed = {link.partition("#")[0] for link in index}
        for guide in GUIDES:
            if guide.name != "README.md":
                self.assertIn(guide.name, listed)

    def test_scripts_are_there(self):
        found = set()
        for page in PAGES:
            for block in BLOCK.finditer(page.read_text(encoding="utf-8")):
                for word in SCRIPT.findall(block[2]):
                    if not re.match(r"\./|\.ci/|tests/|bench/.*\.py", word):
                        continue
                    found.add(word)
                    with self.subTest(page=name_of(page), script=word):
                        made = "./ghostforce" in word  # what a package brings
                        self.assertTrue(made or (ROOT / word).exists())
        self.assertLessEqual({"./demo", "./check"}, found)

    def test_the_readme_is_short(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text(encoding="utf-8").split()), 900)

    def test_commands_and_their_options_are_those_of_the_program(self):
        commands = set(re.findall(r"^  ([a-z][a-z-]*)  ", said_by("--help"), re.MULTILINE))
        self.assertIn("render", commands)
        helps = {command: set(OPTION.findall(said_by("help", command))) for command in commands}
        count = 0
        for page in PAGES:
            for words in calls(page):
                command = words[0]
                if command.startswith("-") or command.isupper():
                    continue
                count += 1
                with self.subTest(page=name_of(page), call=" ".join(words)):
                    self.assertIn(command, commands)
                    for word in words[1:]:
                        if option := OPTION.match(word):
                            self.assertIn(option[0], helps[command])
        self.assertGreater(count, 100)


if __name__ == "__main__":
    unittest.main()
