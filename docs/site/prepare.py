"""Prepares the pages of the site: the Markdown of the repository at its own paths, so that every link stays as it is.

    python3 docs/site/prepare.py target/site     # writes target/site/pages and target/site/zensical.toml

docs/README.md is the index: its headings and the links in its tables are the navigation. Fails if a page of docs is
missing in it, if a link leaves the repository, or if the documents grow beyond `MOST_WORDS`.
"""

import re
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
INDEX = ROOT / "docs" / "README.md"
# Of all documents for readers. The pages of diagnostics grow with the codes, and a program writes the tables of the
# reproduction.
MOST_WORDS = 60_000
UNCOUNTED = ("docs/diagnostics/", "docs/reproduction.md")

# The head of pages that a search leaves out.
UNSEARCHED = "---\nsearch:\n  exclude: true\n---\n"
LINK = re.compile(r"(?<!`)\]\(([^)\s]+)\)")
ENTRY = re.compile(r"^\| \[([^\]]+)\]\(([^)]+)\) \|")
FENCE = re.compile(r"^```(\w*)[^\n`]*$")
ITEM = re.compile(r"^(- |\d+\. )")


def navigation():
    """[(heading, [(title, path from the root, parts)])] of the index. A page `x.md` beside a folder `x` is the index of
    the pages in it: its parts are those that its own tables and lists link to, [(title, path)]."""
    sections = []
    for line in INDEX.read_text().splitlines():
        if line.startswith("## "):
            sections.append((line[3:], []))
        elif entry := ENTRY.match(line):
            page = (INDEX.parent / entry[2]).resolve()
            sections[-1][1].append((entry[1], page.relative_to(ROOT), parts(page)))
    return sections


def parts(page):
    """[(title, path from the root)] of the pages in the folder of a page, in the order in which it links to them."""
    found = {}
    for title, place in re.findall(r"\[([^\]]+)\]\(([^)#]+\.md)[^)]*\)", page.read_text()):
        linked = (page.parent / place).resolve()
        if linked.parent == page.with_suffix("") and linked.exists():
            found.setdefault(linked.relative_to(ROOT), title)
    return [(title, path) for path, title in found.items()]


def portable(text):
    """Markdown as forges read it, in the dialect of the generator: it knows languages of code blocks by one word, and a
    list begins after an empty line."""
    lines, is_code = [], False
    for line in text.splitlines():
        if fence := FENCE.match(line):
            line = line if is_code else f"```{fence[1]}"
            is_code = not is_code
        elif not is_code and ITEM.match(line) and lines and re.match(r"\S", lines[-1]) and not ITEM.match(lines[-1]):
            lines.append("")
        lines.append(line)
    return "\n".join(lines) + "\n"


class Site:
    def __init__(self, pages):
        self.pages, self.done, self.mistakes = pages, set(), []

    def take(self, path):
        """Copies a page or another file that a page links to, with all that it links to; the path of a folder becomes
        that of a list of its files."""
        source = ROOT / path
        if path in self.done:
            return
        self.done.add(path)
        target = self.pages / path
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            target.mkdir(exist_ok=True)
            names = sorted(p.name for p in source.iterdir() if p.is_file() and p.name != "index.md")
            text = f"# {path}\n\n" + "".join(f"- [{name}]({name})\n" for name in names)
            (target / "index.md").write_text(UNSEARCHED + text)
            for name in names:
                self.take(path / name)
        elif source.suffix == ".md":
            head = UNSEARCHED if str(path) == "CHANGELOG.md" else ""
            target.write_text(head + LINK.sub(lambda m: self.link(source, m), portable(source.read_text())))
        else:
            shutil.copyfile(source, target)

    def link(self, source, match):
        """A link in the page `source`, whose file is taken along."""
        place, _, anchor = match[1].partition("#")
        if not place or re.match(r"[a-z]+:", place):
            return match[0]
        linked = (source.parent / place).resolve()
        if not linked.is_relative_to(ROOT) or not linked.exists():
            self.mistakes.append(f"{source.relative_to(ROOT)}: no file {place}")
            return match[0]
        self.take(linked.relative_to(ROOT))
        place += "/index.md" if linked.is_dir() else ""
        return f"]({place}{'#' if anchor else ''}{anchor})"


def words(paths):
    """The number of words of every document, as `wc -w` counts them."""
    return {path: len((ROOT / path).read_text().split()) for path in paths}


def main(folder):
    folder = Path(folder).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    pages = folder / "pages"
    pages.mkdir(parents=True)
    site = Site(pages)
    for path in ["README.md", "docs/README.md", "docs/site/extra.css"]:
        site.take(Path(path))
    sections = navigation()
    entries = [entry for _, entries in sections for entry in entries]
    listed = {path for _, path, _ in entries} | {path for _, _, inside in entries for _, path in inside}
    for path in sorted(listed):
        site.take(path)
    documents = sorted(p.relative_to(ROOT) for p in (ROOT / "docs").rglob("*.md"))
    for path in documents:
        if path not in listed and path != INDEX.relative_to(ROOT):
            site.mistakes.append(f"{path}: docs/README.md does not list this page")
    settings = (HERE / "zensical.toml").read_text()
    at = settings.index("[project.theme]")
    (folder / "zensical.toml").write_text(settings[:at] + nav(sections) + "\n" + settings[at:])
    counted = words([Path("README.md")] + [p for p in documents if not str(p).startswith(UNCOUNTED)])
    total = sum(counted.values())
    print("\n".join(f"{number:6} {path}" for path, number in counted.items()))
    print(f"{total:6} words in all; at most {MOST_WORDS}")
    if total > MOST_WORDS:
        site.mistakes.append(f"{total} words: shorten the documents")
    for mistake in site.mistakes:
        print(f"mistake: {mistake}", file=sys.stderr)
    return 1 if site.mistakes else 0


def nav(sections):
    """The navigation in the generator's settings."""
    lines = ["nav = [", '  { "mavc" = "README.md" },', '  { "All pages" = "docs/README.md" },']
    for heading, entries in sections:
        lines.append(f'  {{ "{heading}" = [')
        for title, path, inside in entries:
            pages = [(title, path)] if not inside else [("Overview", path), *inside]
            listed = ", ".join(f'{{ "{t}" = "{p}" }}' for t, p in pages)
            lines.append(f'    {{ "{title}" = [{listed}] }},' if inside else f"    {listed},")
        lines.append("  ] },")
    return "\n".join(lines + ["]"]) + "\n"


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
