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
BLOCK = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
WORDS = r"(?:\./demo|ghostforce)((?: [^\s`|#>]+)+)"
CALL_IN_BLOCK = re.compile(r"^ *(?:\$ )?(?:build/release/bin/)?" + WORDS, re.MULTILINE)
CALL_IN_TEXT = re.compile("`" + WORDS)
OPTION = re.compile(r"--[a-z][a-z-]*")
# What a reader can do where they read it: a line of a block that is no data, or a cell that begins a row of a table.
SHOWN_BLOCK = re.compile(r"^```(?!toml|yaml|json|csv|html|cmake|cpp)\w*\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINE = re.compile(r"^ *(?:\$ )?(?:\./demo|ghostforce)( [^#\n]+)", re.MULTILINE)
ROW = re.compile(r"^\| `(?:\./demo|ghostforce)( [^`]+)`", re.MULTILINE)
# That wants a window, a device, a shell's loop or pipe, a tool that may be missing, or a file that is the reader's own.
NOT_HERE = re.compile(r"^ *(?:$|-|run\b|doctor\b)|[$|…]|\.(?:mp4|webm)\b|\b(?:my[-_]|visit|steep|pictures|from-a-browser)|\*")
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
    blocks = "\n".join(BLOCK.findall(text))
    for found in CALL_IN_BLOCK.findall(blocks) + CALL_IN_TEXT.findall(BLOCK.sub("", text)):
        try:
            yield shlex.split(found)
        except ValueError:  # quotes that end on another line
            yield found.split()


def lines_to_try(page):
    """From the page's beginning to its end: later ones read what earlier ones have written."""
    text = page.read_text(encoding="utf-8").replace("\\\n", " ")
    blocks = [(block.start(), line) for block in SHOWN_BLOCK.finditer(text) for line in LINE.findall(block[1])]
    rows = [(row.start(), row[1]) for row in ROW.finditer(text)]
    return [line for _, line in sorted(blocks + rows, key=lambda found: found[0]) if not NOT_HERE.search(line)]


def said_by(*words):
    answer = subprocess.run([os.environ["GHOSTFORCE"], *words], capture_output=True, text=True, check=True)
    return answer.stdout


class Guides(unittest.TestCase):
    def test_commands_do_what_their_page_promises(self):
        count = 0
        for page in PAGES[:1] + GUIDES:
            with tempfile.TemporaryDirectory(prefix="ghostforce-guide-") as folder:
                (pathlib.Path(folder) / "docs").mkdir()  # where the pictures of the guides lie
                for line in lines_to_try(page):
                    words = [os.environ["GHOSTFORCE"], *shlex.split(line)]
                    env = {**os.environ, "HOME": folder}
                    answer = subprocess.run(words, cwd=folder, env=env, stdin=subprocess.DEVNULL, capture_output=True, text=True)
                    self.assertEqual(answer.returncode, 0, f"{name_of(page)}:{line}\n{answer.stderr}")
                    count += 1
        self.assertGreater(count, 30)

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
            for block in BLOCK.findall(page.read_text(encoding="utf-8")):
                for word in SCRIPT.findall(block):
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
