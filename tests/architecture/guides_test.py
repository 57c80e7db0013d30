"""README.md and docs/: links lead somewhere, each guide is in the index, and commands are those that the program has.

GHOSTFORCE in the environment is the program.
"""
import os
import pathlib
import re
import shlex
import subprocess
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


def said_by(*words):
    answer = subprocess.run([os.environ["GHOSTFORCE"], *words], capture_output=True, text=True, check=True)
    return answer.stdout


class Guides(unittest.TestCase):
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
