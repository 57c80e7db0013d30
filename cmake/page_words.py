"""page_words.py LANGUAGE.toml ...

Prints the words of the page's own script as JSON: of each language, by its code, the table [page] of its file in
assets/languages.
"""

import json
import pathlib
import sys
import tomllib

words = {}
for file in sys.argv[1:]:
    language = tomllib.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    words[language["code"]] = language["page"]
# Within a script nothing may look like its end.
print(json.dumps(words, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c"))
