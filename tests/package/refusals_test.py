"""What ./package refuses to make, before it installs or builds anything."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOBODY = {"GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_SYSTEM": "/dev/null"}
SOMEBODY = {f"GIT_{role}_{what}": "a@b" for role in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}


class Package(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="ghostforce-package-")
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name)
        (self.tree / "cmake").mkdir()
        for name in ("package", "packages.txt", "cmake/setup.sh"):
            shutil.copy2(ROOT / name, self.tree / name)
        (self.tree / ".gitignore").write_text("build/\n", encoding="utf-8")
        # Should it refuse too late, it must neither install anything nor ask for a password.
        programs = self.tree / "build-tools"
        programs.mkdir()
        for name in ("apt-get", "sudo"):
            (programs / name).write_text("#!/bin/sh\nexit 97\n", encoding="utf-8")
            (programs / name).chmod(0o755)
        self.path = f"{programs}:{os.environ['PATH']}"
        self.git("init", "--quiet")
        self.commit()

    def git(self, *words):
        subprocess.run(["git", *words], cwd=self.tree, env={**os.environ, **NOBODY, **SOMEBODY}, check=True)

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message=all")

    def expect_refused(self, words, *arguments, **environment):
        kept = {name: value for name, value in os.environ.items() if name not in ("DEBFULLNAME", "DEBEMAIL")}
        answer = subprocess.run(
            ["./package", *arguments], cwd=self.tree, env={**kept, **NOBODY, **environment, "PATH": self.path}, capture_output=True, text=True
        )
        self.assertEqual(answer.returncode, 1, answer.stderr)
        self.assertIn(words, answer.stderr)
        self.assertFalse((self.tree / "build").exists())

    def test_what_is_not_committed(self):
        (self.tree / "new").touch()
        self.expect_refused("is not what is committed", DEBFULLNAME="A", DEBEMAIL="a@b")
        self.commit()
        (self.tree / "packages.txt").write_text("", encoding="utf-8")
        self.expect_refused("is not what is committed", DEBFULLNAME="A", DEBEMAIL="a@b")

    def test_a_package_for_which_nobody_answers(self):
        self.expect_refused("names who answers for it")
        self.expect_refused("names who answers for it", DEBFULLNAME="A")
        self.expect_refused("names who answers for it", "--modified", DEBEMAIL="a@b")

    def test_other_arguments(self):
        self.expect_refused("takes no argument but --modified", "--all")


if __name__ == "__main__":
    unittest.main()
