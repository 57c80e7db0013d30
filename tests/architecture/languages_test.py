"""A language of the stage that lacks something is refused while the program is built, in words that say what."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

LANGUAGES = pathlib.Path(__file__).resolve().parents[2] / "cmake" / "languages.py"
MODEL = """
code = "en"
[labels]
slid = "slid"
deep = "{} mm deep"
[modes]
why = { title = "Why?", about = "In four steps." }
[motors]
reasons = ["off", "too fast"]
[[buttons]]
text = "One"
[[buttons]]
text = "Two"
"""


class Languages(unittest.TestCase):
    def build(self, other):
        with tempfile.TemporaryDirectory() as folder:
            files = [pathlib.Path(folder) / name for name in ("words.h", "words.cpp", "english.toml", "other.toml")]
            files[2].write_text(MODEL, encoding="utf-8")
            files[3].write_text(other, encoding="utf-8")
            done = subprocess.run([sys.executable, LANGUAGES, *files], capture_output=True, text=True, check=False)
            return done.stderr, [file.read_text(encoding="utf-8") for file in files[:2] if file.exists()]

    def test_makes_a_struct_and_a_table_for_each(self):
        problem, (header, source) = self.build(MODEL.replace('"en"', '"xx"').replace('"slid"', '"\\"resbaló\\"\\n"'))
        self.assertEqual(problem, "")
        self.assertIn("std::string_view deep;", header)
        self.assertIn("Mode why;", header)
        self.assertIn("std::array<Button, 2> buttons;", header)
        self.assertIn("extern const StageLanguage english_stage;\nextern const StageLanguage other_stage;", header)
        self.assertIn(r'.slid = "\"resbaló\"\n"', source)

    def test_refuses_what_differs_from_the_model(self):
        for before, after, words in [
            ('slid = "slid"\n', "", "other.toml: labels lacks the key slid"),
            ('slid = "slid"', 'slid = ""', "other.toml: labels.slid is ''; it wants words"),
            ('slid = "slid"', 'slid = "slid"\nslud = "so"', "other.toml: labels has the key slud"),
            ("{} mm deep", "deep", "other.toml: labels.deep is 'deep'; it wants words, with as many {} as in"),
            (', about = "In four steps."', "", "other.toml: modes.why lacks the key about"),
            ('"off", "too fast"', '"off"', "other.toml: motors.reasons has 1 entries, and the model has 2"),
            ('text = "Two"', "text = 2", "other.toml: buttons[1].text is 2"),
        ]:
            with self.subTest(words):
                self.assertIn(before, MODEL)
                problem, made = self.build(MODEL.replace(before, after))
                self.assertIn(words, problem)
                self.assertEqual(made, [])


if __name__ == "__main__":
    unittest.main()
