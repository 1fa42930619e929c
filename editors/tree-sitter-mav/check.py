"""Checks of the tree-sitter grammar: `bash check.sh`.

- Every spec of the repository whose text the compiler accepts parses without ERROR or MISSING nodes, and so does what
  the snippets of editors/vscode insert.
- Texts read the same after an edit as from the start.
- The words that end a unit are those of grammar/mav.pest.
- The corpus, in the format of `tree-sitter test`, which runs it too.
- The queries fit the grammar, and words are highlighted as the carets in test/highlight say.
"""

import ctypes
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from tree_sitter import Language, Node, Parser, Query, QueryCursor, Tree

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def language(library: str) -> Language:
    """The grammar in the shared library at this path."""
    parser = ctypes.CDLL(library).tree_sitter_mav
    parser.restype = ctypes.c_void_p
    capsule = ctypes.pythonapi.PyCapsule_New
    capsule.restype = ctypes.py_object
    capsule.argtypes = (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)
    return Language(capsule(parser(), b"tree_sitter.Language", None))


# ---- specs


def specs() -> Iterator[tuple[str, bytes]]:
    """Name and text of every spec without errors of syntax: files, the blocks of code in the documents, snippets.

    A snapshot lists what the compiler reports of each file below `tests/specs/errors`.
    """
    messages = (ROOT / "tests/specs/errors/messages.snap").read_text()
    reports = dict(re.findall(r"^(\w+)\.mav\n((?:  .*\n)*)", messages, re.M))
    folders = ["specs", "examples", "tests", "src"]
    for path in sorted(file for folder in folders for file in (ROOT / folder).rglob("*.mav")):
        if "errors" in path.parts and "mavc::syntax::" in reports.get(path.stem, "mavc::syntax::"):
            continue
        if any(path.is_relative_to(ROOT / "tests/specs" / folder) for folder in ["errors/syntax", "several", "many"]):
            continue
        yield str(path.relative_to(ROOT)), path.read_bytes()
    for page in [ROOT / "README.md", ROOT / "docs/language.md"]:
        for number, block in enumerate(re.findall(r"^```mav\S*\n(.*?)^```", page.read_text(), re.S | re.M), 1):
            yield f"{page.relative_to(ROOT)}, block {number}", block.encode()
    for name, snippet in json.loads((HERE.parent / "vscode/snippets/mav.json").read_text()).items():
        body = snippet["body"]
        yield f"snippet {name!r}", inserted(body if isinstance(body, str) else "\n".join(body)).encode()


def inserted(snippet: str) -> str:
    """What a snippet inserts: its placeholders with their texts, the first of each choice, once more where repeated."""
    texts = dict(re.findall(r"\$\{(\d+):([^$}]*)\}", snippet))
    chosen = re.sub(r"\$\{\d+\|([^,|]*)[^}]*\|\}", r"\1", snippet)
    repeated = re.sub(r"\$(\d)", lambda place: texts.get(place[1], ""), chosen)
    return re.sub(r"\$\{\d+:([^}]*)\}", r"\1", repeated)


def mistakes(node: Node) -> Iterator[str]:
    """What is wrong at and below a node, each with its place."""
    if node.is_error or node.is_missing:
        line, column = node.start_point
        yield f"{line + 1}:{column + 1}: {'MISSING' if node.is_missing else 'ERROR'} {node.text!r}"
    for child in node.children:
        yield from mistakes(child) if child.has_error or child.is_missing else ()


def check_specs(parser: Parser) -> Iterator[str]:
    count = 0
    for count, (name, text) in enumerate(specs(), 1):
        tree = parser.parse(text)
        yield from (f"{name}:{mistake}" for mistake in mistakes(tree.root_node))
        # Byte order marks and carriage returns change nothing.
        windows = parser.parse(b"\xef\xbb\xbf" + text.replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"))
        if str(windows.root_node) != str(tree.root_node):
            yield f"{name}: read in another way with the line ends of Windows"
    if count < 100:
        yield f"only {count} specs were found"
    print(f"{count} specs")


# ---- edits


def point(text: bytes, at: int) -> tuple[int, int]:
    """Row and column, in bytes."""
    return text.count(b"\n", 0, at), at - (text.rfind(b"\n", 0, at) + 1)


def check_edits(parser: Parser) -> Iterator[str]:
    """A text from which a bracket is taken reads the same whether an editor goes on from the old tree or not."""
    count = 0
    for name, text in specs():
        for bracket in re.finditer(rb"[(){}\[\]]", text):
            count += 1
            at = bracket.start()
            edited = text[:at] + text[at + 1 :]
            old = parser.parse(text)
            old.edit(at, at + 1, at, point(text, at), point(text, at + 1), point(text, at))
            if str(parser.parse(edited, old).root_node) != str(parser.parse(edited).root_node):
                yield f"{name}: without the bracket at byte {at} the tree depends on what was there before"
    print(f"{count} edits")


# ---- words


def check_words() -> Iterator[str]:
    pest = (ROOT / "grammar/mav.pest").read_text()

    def rule(name: str) -> set[str]:
        text = re.search(rf"^{name}\s*= @\{{(.*?)\}}$", pest, re.S | re.M)
        return set(re.findall(r'"(\w+)"', text[1] if text else ""))

    clauses = rule("clause_word")
    of_waypoints = rule("bare_word") | rule("arrive_word")
    continuing = clauses | of_waypoints | rule("continuing_word")
    rules = json.loads((HERE / "src/grammar.json").read_text())["rules"]
    scanner = re.search(r"CONTINUING_WORDS\[\] = \{(.*?)\};", (HERE / "src/scanner.c").read_text(), re.S)
    # Where the grammar for VS Code says which words are no units.
    colours = re.sub(r"\(\?#[^)]*\)", "", (HERE.parent / "vscode/syntaxes/mav.tmLanguage.json").read_text())
    no_units = re.search(r"\[0-9\]\+.*\(\?!\(\?:([\w|]+)\)\\\\b\)", colours)
    for place, found, expected in [
        ("grammar.js", set(re.findall(r"'STRING', 'value': '(\w+)'", str(rules["clause"]))), clauses),
        ("scanner.c", set(re.findall(r'"(\w+)"', scanner[1] if scanner else "")), continuing),
        ("mav.tmLanguage.json", set(no_units[1].split("|")) if no_units else set(), continuing),
    ]:
        if found != expected or not expected:
            yield f"{place}: these words differ from those of grammar/mav.pest: {sorted(found ^ expected)}"


# ---- corpus

CASE = re.compile(r"^={3,}\n(?P<title>.+)\n={3,}\n(?P<text>(?:.*\n)*?)-{3,}\n(?P<tree>(?:(?!={3,}$).*\n?)*)", re.M)


def indented(tree: str) -> str:
    """A tree as the corpus writes it, one node a line."""
    depth, lines = 0, []
    for part in re.findall(r'(?:\w+: )?\((?:MISSING "[^"]+"|MISSING \w+|UNEXPECTED .+?(?=\))|\w+)|\)', tree):
        if part == ")":
            depth -= 1
            lines[-1] += ")"
        else:
            lines.append("  " * depth + part)
            depth += 1
    return "\n".join(lines)


def check_corpus(parser: Parser) -> Iterator[str]:
    count = 0
    for path in sorted((HERE / "test/corpus").glob("*.txt")):
        cases = list(CASE.finditer(path.read_text()))
        if not cases:
            yield f"{path.name}: no cases"
        for case in cases:
            count += 1
            found = indented(str(parser.parse(case["text"][1:-1].encode()).root_node))
            if found != case["tree"].strip():
                yield f"{path.name}: {case['title']}\n--- expected\n{case['tree'].strip()}\n--- found\n{found}"
    print(f"{count} cases of the corpus")


# ---- queries


def captures(query: Query, tree: Tree) -> dict[tuple[int, int], list[str]]:
    """The captures at each node, by its first and last byte."""
    found: dict[tuple[int, int], list[str]] = {}
    for name, nodes in QueryCursor(query).captures(tree.root_node).items():
        for node in nodes:
            found.setdefault((node.start_byte, node.end_byte), []).append(name)
    return found


def check_highlights(language: Language, parser: Parser) -> Iterator[str]:
    query = Query(language, (HERE / "queries/highlights.scm").read_text())
    for name, text in specs():
        for (start, end), names in captures(query, parser.parse(text)).items():
            if len(names) > 1:
                yield f"{name}: {text[start:end]!r} is captured as each of {names}"
    count = 0
    for path in sorted((HERE / "test/highlight").glob("*.mav")):
        text = path.read_text()
        found = captures(query, parser.parse(text.encode()))
        spec, begins = None, []
        for at, line in [(sum(map(len, text.splitlines(True)[:i])), line) for i, line in enumerate(text.splitlines())]:
            claim = re.fullmatch(r" *//( *)(\^+|<-) (\S+)", line)
            if not claim:
                spec, begins = line, at
                continue
            count += 1
            column = line.index("^") if "^" in line else line.index("//")
            names = [n for (start, end), ns in found.items() if start <= begins + column < end for n in ns]
            if names != [claim[3]]:
                yield f"{path.name}: {spec.strip()!r}, column {column + 1}: expected {claim[3]}, found {names}"
    if count == 0:
        yield "no claims in test/highlight"
    print(f"{count} claims on highlights")


def check_folds(language: Language, parser: Parser) -> Iterator[str]:
    query = Query(language, (HERE / "queries/folds.scm").read_text())
    text = "plan {\n    at = [1,\n    2]\n}\n"
    found = captures(query, parser.parse(text.encode()))
    folds = sorted(text[start:end].count("\n") + 1 for start, end in found)
    if folds != [2, 4]:
        yield f"folds of {folds} lines, expected 2 and 4"


def main() -> int:
    mav = language(sys.argv[1])
    parser = Parser(mav)
    wrong = [
        *check_specs(parser),
        *check_edits(parser),
        *check_words(),
        *check_corpus(parser),
        *check_highlights(mav, parser),
        *check_folds(mav, parser),
    ]
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
