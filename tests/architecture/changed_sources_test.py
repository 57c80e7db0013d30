"""cmake/changed_sources.py, in small repositories made for it."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "cmake/changed_sources.py"
FILES = {
    "core/wall.h": "// a wall\n",
    "core/wall.cpp": '#include "core/wall.h"\n',
    "core/tick.h": '#include "core/wall.h"\n',
    "core/hand.cpp": "#include <cmath>\n",
    "app/view/stage.cpp": '#include <cmath>\n#  include "core/tick.h"\n',
    "app/paint/web/opengl.h": "// another one\n",
    "app/paint/desktop/opengl.h": "// one\n",
    "app/paint/painter.cpp": '#include "opengl.h"\n',
    "bench/tick_bench.cpp": '// #include "core/wall.h"\n#include "core/hand.h"\n',
    "device/servo.cpp": "// no includes\n",
    "tests/core/wall_test.cpp": '#include "core/wall.h"\n',
    "README.md": "words\n",
}
ALL = sorted(path for path in FILES if path.endswith(".cpp"))
HOUR_S = 3600


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class ChangedSources(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        for path, text in FILES.items():
            self.write(path, text)
        self.script = self.root / "cmake" / SCRIPT.name
        self.script.parent.mkdir()
        shutil.copy(SCRIPT, self.script)
        # Whatever repository this one stands in.
        self.environment = {key: value for key, value in os.environ.items() if not key.startswith("GIT_")}
        self.environment |= {"GIT_CEILING_DIRECTORIES": str(self.root.parent), "GIT_CONFIG_GLOBAL": os.devnull}

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def git(self, *arguments, **environment):
        subprocess.run(
            ["git", "-C", self.root, "-c", "user.name=n", "-c", "user.email=e", *arguments],
            env={**self.environment, **environment}, check=True, capture_output=True,
        )  # fmt: skip

    def commit(self, at_hour, *changed):
        """With a line more in these files."""
        for path in changed:
            self.write(path, FILES[path] + f"// {at_hour}\n")
        if not (self.root / ".git").exists():
            self.git("init")
        self.git("add", "--all")
        date = f"{1_700_000_000 + at_hour * HOUR_S} +0000"
        self.git("commit", "--allow-empty", "--message", "a change", GIT_AUTHOR_DATE=date, GIT_COMMITTER_DATE=date)

    def run_script(self, *arguments):
        return subprocess.run(
            [sys.executable, "-B", self.script, *arguments],
            env=self.environment, capture_output=True, text=True, check=False,
        )  # fmt: skip

    def found(self, *arguments):
        answer = self.run_script(*arguments)
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        return answer.stdout.splitlines()

    def test_are_those_of_the_last_day(self):
        self.commit(0)
        self.commit(1, "device/servo.cpp")
        self.commit(20, "core/hand.cpp")
        self.commit(25, "README.md")
        self.assertEqual(self.found(), ["core/hand.cpp"])
        self.assertEqual(self.found("HEAD"), [])
        self.assertEqual(self.found("HEAD~3"), ["core/hand.cpp", "device/servo.cpp"])

    def test_and_those_that_include_what_has_changed_even_by_another_header(self):
        self.commit(0)
        self.commit(30, "core/wall.h")
        self.assertEqual(self.found(), ["app/view/stage.cpp", "core/wall.cpp", "tests/core/wall_test.cpp"])

    def test_a_header_that_is_included_by_its_name_alone_counts_wherever_it_is(self):
        self.commit(0)
        self.commit(30, "app/paint/web/opengl.h")
        self.assertEqual(self.found(), ["app/paint/painter.cpp"])

    def test_what_is_not_committed_counts_too(self):
        self.commit(0)
        self.commit(30)
        self.write("core/new.cpp", '#include "core/new.h"\n')
        self.write("core/hand.cpp", "// changed\n")
        self.write("core/hand.h", "// new\n")
        self.git("add", "core/hand.h")
        self.assertEqual(self.found(), ["bench/tick_bench.cpp", "core/hand.cpp", "core/new.cpp"])

    def test_a_header_that_is_gone_breaks_those_that_want_it(self):
        self.commit(0)
        (self.root / "core/tick.h").unlink()
        self.assertEqual(self.found("HEAD"), ["app/view/stage.cpp"])

    def test_are_all_of_a_short_history(self):
        self.commit(0)
        self.commit(23, "core/hand.cpp")
        self.assertEqual(self.found(), ALL)

    def test_are_all_without_a_history(self):
        self.assertEqual(self.found(), ALL)

    def test_are_all_where_the_history_is_another_projects(self):
        self.commit(0)
        self.commit(30)
        inner = self.root / "unpacked"
        for path, text in FILES.items():
            self.write(f"unpacked/{path}", text)
        (inner / "cmake").mkdir()
        self.script = pathlib.Path(shutil.copy(SCRIPT, inner / "cmake"))
        self.assertEqual(self.found(), ALL)

    def test_a_commit_that_is_not_there_is_told_of(self):
        self.commit(0)
        answer = self.run_script("nonsense")
        self.assertEqual((answer.returncode, answer.stdout), (1, ""))
        self.assertEqual(answer.stderr, "nonsense: git knows no such commit here.\n")


if __name__ == "__main__":
    unittest.main()
