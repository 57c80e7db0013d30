"""The worked examples of CONTRIBUTING.md can be followed: their files and lines are where they say, what their code names
is there, and what needs no compiler works with this program. That the rest compiles and works, .ci/long sees."""
import os
import pathlib
import re
import tempfile
import unittest

import examples
from examples import Command, Edit, Example, Files, Wrong, follow, matches, read_examples, root

text = examples.document.read_text(encoding="utf-8")
kinds = ["A scene", "A lesson", "A figure", "A panel", "An input", "A strategy"]

cpp_keyword = {"class", "const", "constexpr", "else", "enum", "extern", "inline", "new", "noexcept", "override",
               "public", "private", "return", "static", "struct", "using"}


def code_of(source):
    """Without comments, texts and include lines."""
    return re.sub(r'//.*|"(?:[^"\\]|\\.)*"|#include.*', " ", source)


def words_of(source):
    return set(re.findall(r"\b[A-Za-z_]\w*", code_of(source)))


def declared_in(source):
    """Names after a type, as in `double name` or `Vector<2> name`; and enumerators, which stand in their own list."""
    pairs = re.findall(r"\b(\w+)(?:<[\w<>:, ]*>)?[&*]? +[&*]?(?=(\w+))", code_of(source))
    enumerators = re.findall(r"enum class \w+ .*\{(.*)\}", source)
    return {name for before, name in pairs if before not in cpp_keyword - {"class", "struct"}} | {
        word for list_ in enumerators for word in re.findall(r"\w+", list_)}


def sources():
    for folder in ("core", "device", "app"):
        for path in (root / folder).rglob("*"):
            if path.suffix in (".h", ".cpp"):
                yield path.read_text(encoding="utf-8")


def is_path(span):
    return re.fullmatch(r"(?:\.ci|app|assets|cmake|core|device|docs|shaders|tests)/[\w./-]+", span) is not None


class Examples(unittest.TestCase):
    def setUp(self):
        self.examples = read_examples(text)

    def test_each_kind_has_one(self):
        self.assertEqual([each.title for each in self.examples], kinds)
        for each in self.examples:
            self.assertTrue(any(command.is_built for command in each.commands), each.title)

    def test_each_can_be_followed_by_itself_and_all_one_after_another(self):
        for each in self.examples:
            follow([each], root)
        follow(self.examples, root)

    def test_what_their_code_names_is_there(self):
        code = [edit.text for each in self.examples for edit in each.edits if edit.path.endswith((".h", ".cpp"))]
        known = cpp_keyword.union(*map(declared_in, code), *map(words_of, sources()))
        for source in code:
            self.assertEqual(sorted(words_of(source) - known), [], source)

    def test_the_files_that_they_include_are_there(self):
        files = follow(self.examples, root)
        for each in self.examples:
            for edit in each.edits:
                for path in re.findall(r'#include "(.+)"', edit.text):
                    self.assertIsNotNone(files[path], f"{edit.path} includes {path}")

    def test_what_needs_no_compiler_works(self):
        commands = 0
        for each in self.examples:
            with tempfile.TemporaryDirectory() as folder:
                new = [edit for edit in each.edits if not edit.place]
                follow([Example(each.title, new)], root).write(folder)
                for command in each.commands:
                    if not command.is_built:
                        command.run(os.environ["GHOSTFORCE_PROGRAM"], folder)
                        commands += 1
        self.assertGreaterEqual(commands, 2)

    def test_the_paths_that_the_text_names_are_there(self):
        files = follow(self.examples, root)
        prose = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
        links = re.findall(r"\]\(([^)#:]+)", prose)
        paths = {span for span in re.findall(r"`([^`]+)`", prose) if is_path(span)}.union(links)
        self.assertGreater(len(paths), 15)
        for path in sorted(paths):
            there = (root / path).exists() or files[path] is not None or any(root.glob(f"{path}.*"))
            self.assertTrue(there, f"there is no {path}")


class TheTestItself(unittest.TestCase):
    """It must be able to fail."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name)
        (self.tree / "a.h").write_text("one\ntwo\ntwo and three\n", encoding="utf-8")

    def text_after(self, edit):
        return follow([Example("A test", [edit])], self.tree)["a.h"]

    def test_puts_a_block_where_it_belongs(self):
        self.assertEqual(self.text_after(Edit("a.h", "new\n", "after", "one")), "one\nnew\ntwo\ntwo and three\n")
        self.assertEqual(self.text_after(Edit("a.h", "new\n", "before", "one")), "new\none\ntwo\ntwo and three\n")
        self.assertEqual(self.text_after(Edit("a.h", "new\n", "instead of", "three")), "one\ntwo\nnew\n")

    def test_refuses_what_cannot_be_followed(self):
        for edit in (Edit("a.h", "new\n"), Edit("a.h", "new\n", "after", "two"), Edit("a.h", "new\n", "after", "four"),
                     Edit("b.h", "new\n", "after", "one")):
            with self.assertRaises(Wrong):
                self.text_after(edit)

    def test_refuses_blocks_that_nothing_explains(self):
        read_examples("### A test\n**New file** `a.h`:\n```\none\n```\n")
        for heading in ("", "**Inside** `a.h`:\n", "**In** `a.h`, behind the line with `one`:\n"):
            with self.assertRaises(Wrong):
                read_examples(f"### A test\n{heading}```\none\n```\n")

    def test_compares_what_a_command_prints(self):
        self.assertTrue(matches("a … c\n…\nz\n", "a b c\nd\ne\nz\n"))
        self.assertFalse(matches("a … c\nz\n", "a b c\nd\nz\n"))
        with self.assertRaises(Wrong):
            Command("echo two", "one\n", False).run("program", self.tree)
        with self.assertRaises(Wrong):
            Command("exit 3", "", False).run("program", self.tree)

    def test_writes_no_file_that_it_only_looked_for(self):
        files = Files(self.tree)
        self.assertIsNone(files["b.h"])
        files.write(self.tree)
        self.assertFalse((self.tree / "b.h").exists())

    def test_knows_a_name_that_is_nowhere(self):
        source = 'double twice(double x) { return no_such_name(x); }  // no_comment "no_text"'
        self.assertEqual(words_of(source) - declared_in(source) - cpp_keyword - {"double"}, {"no_such_name"})
