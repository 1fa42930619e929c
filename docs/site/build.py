"""Builds the prepared site, with colours for specs: `python3 build.py` in its folder.

The generator colours code by Pygments, which does not know the language of mavc. Words are coloured by what follows
them, so that no list of words has to be kept.
"""

import sys
from types import ModuleType

from pygments.lexer import RegexLexer
from pygments.lexers import _mapping
from pygments.token import Comment, Keyword, Name, Number, Operator, String, Text
from zensical.main import cli


class MavLexer(RegexLexer):
    name, aliases, filenames = "mav", ["mav"], ["*.mav"]
    tokens = {
        "root": [
            (r"//.*", Comment.Single),
            (r'"[^"\n]*"', String),
            (r"\d[\d_]*(\.\d+)?(e[+-]?\d+)?", Number),
            # Words that begin a statement or come before a brace, and names of fields.
            (r"^\s*[A-Za-z_]\w*(?=\s+[^=\s])", Keyword),
            (r"[A-Za-z_]\w*(?=[^\n{}=;]*\{)", Keyword),
            (r"[A-Za-z_]\w*(?=\s*=)", Name.Attribute),
            (r"[A-Za-z_]\w*", Name),
            (r"\s+", Text),
            (r".", Operator),
        ]
    }


def main():
    module = ModuleType("mav_lexer")
    module.MavLexer = MavLexer
    sys.modules[module.__name__] = module
    _mapping.LEXERS["MavLexer"] = (module.__name__, "mav", ("mav",), ("*.mav",), ())
    cli(["build", "--strict"])


if __name__ == "__main__":
    main()
