"""page_binary.py PAGE.html

Writes the program in the page, which Emscripten has put there as base64, as a string of one letter for each byte. The
commonest bytes get letters that take one byte in UTF-8, the others such that take two: the file becomes smaller than
with base64, which takes four letters for three bytes. It also becomes smaller on its way from a server, because what
occurs twice in the program looks the same both times. page.html has the reader and the place, PROGRAM_HERE.
"""

import base64
import collections
import pathlib
import re
import sys

# No sign that ends a string or a script, or that is no sign of its own.
one_byte = [chr(code) for code in range(0x20, 0x7F) if chr(code) not in '"\\<`$']
two_bytes = [chr(code) for code in range(0xA1, 0x180) if code != 0xAD]

file = pathlib.Path(sys.argv[1])
page = file.read_text(encoding="utf-8")
found = re.findall(r"data:application/octet-stream;base64,([A-Za-z0-9+/=]{1000,})", page)
if len(found) != 1 or page.count("PROGRAM_HERE") != 1:
    sys.exit(f"{file}: wants one program in base64 and one place for it; has {len(found)}")
program = base64.b64decode(found[0])
count = collections.Counter(program)
by_count = sorted(range(256), key=lambda byte: (-count[byte], byte))
letters = dict(zip(by_count, one_byte + two_bytes))
alphabet = "".join(letters[byte] for byte in range(256))
text = "".join(map(letters.__getitem__, program))
page = page.replace(found[0], "").replace("PROGRAM_HERE", f'"{alphabet}", "{text}"')
file.write_text(page, encoding="utf-8")
