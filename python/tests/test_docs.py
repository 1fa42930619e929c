"""The examples of docs/python.md, run one after the other in one program."""

import re
import warnings

import pytest

BLOCK = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)


def test_examples_run(example, tmp_path, monkeypatch, capsys):
    pytest.importorskip("rosbags")
    monkeypatch.chdir(tmp_path)
    page = example("docs/python.md")
    blocks = list(BLOCK.finditer(page))
    assert len(blocks) >= 5
    known: dict = {"__name__": "__main__"}
    for block in blocks:
        line = page.count("\n", 0, block.start(1))
        # Errors have the line of the page.
        code = compile("\n" * line + block[1], "docs/python.md", "exec")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            exec(code, known)
    printed = capsys.readouterr().out
    assert "/command/trajectory 1501 points" in printed
    # What the comments of the page say.
    assert str(known["text"].unknown) in page and known["text"].unknown
    assert known["diagnosis"].motors == (1,) and known["losses"]["kind"].tolist() == ["held"]
    assert known["quad"].modes == ("M1", "M2", "M3", "M4")
    deepest, highest = map(float, next(line for line in printed.splitlines() if line.startswith("-")).split())
    assert abs(deepest - highest) < 0.01 * abs(highest)
