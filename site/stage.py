"""Collects the pages of the site in a folder: docs/, and pages that lie elsewhere, with links that work there.

usage: stage.py FOLDER
"""

import posixpath
import re
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
REPOSITORY = "https://github.com/striata/striata"

#: Pages that are not in docs/, by their place in the site.
ELSEWHERE = {"index.md": "README.md", "gallery.md": "site/gallery.md", "changelog.md": "CHANGELOG.md"}
PLACES = {source: place for place, source in ELSEWHERE.items()}

#: A link in Markdown, or an attribute of HTML: what comes before, the path, and the anchor.
LINK = re.compile(r'(\]\(|(?:src|href)=")([^)\s"#]+)(#[^)\s"]*)?')
CODE = re.compile(r"^(```.*?^```[^\n]*$)", re.MULTILINE | re.DOTALL)


def staged(text, source, place):
    """The text of a page whose links lead to pages of the site, or to files of the repository."""

    def linked(match):
        before, path, anchor = match.group(1), match.group(2), match.group(3) or ""
        # The gallery refers to other parts of the site.
        if ":" in path or path.startswith(("/", "../viewer/")):
            return match.group(0)
        target = posixpath.normpath(posixpath.join(posixpath.dirname(source), path))
        known = PLACES.get(target)
        if known is None and target.startswith("docs/") and (ROOT / target).is_file():
            known = target.removeprefix("docs/")
        if known is None:
            if not (ROOT / target).exists():
                raise SystemExit(f"{source} refers to {path}, which does not exist")
            kind = "tree" if (ROOT / target).is_dir() else "blob"
            return f"{before}{REPOSITORY}/{kind}/main/{target}{anchor}"
        relative = posixpath.relpath(known, posixpath.dirname(place) or ".")
        # Each page becomes a folder, which links in HTML have to know.
        if before != "](" and place != "index.md":
            relative = f"../{relative}"
        return f"{before}{relative}{anchor}"

    parts = CODE.split(text)
    return "".join(part if part.startswith("```") else LINK.sub(linked, part) for part in parts)


def main():
    folder = Path(sys.argv[1])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "docs", folder)
    pages = {path.relative_to(folder).as_posix(): f"docs/{path.relative_to(folder).as_posix()}" for path in folder.rglob("*.md")}
    for place, source in (pages | ELSEWHERE).items():
        (folder / place).write_text(staged((ROOT / source).read_text("utf-8"), source, place), "utf-8")


main()
