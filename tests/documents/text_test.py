#!/usr/bin/env python3
"""What pages say of the source is true: paths, links, lengths, and the numbers of result files."""
import re
import subprocess
import sys

from documents import SOURCE, difference, pages

LONGEST = {"README.md": 150, "BENCHMARKS.md": 200}
# What is written in backticks and looks like a path, or like a file of the source.
PATH = re.compile(r"`([\w.+*-]+/[\w./+*{},-]*|[\w+*-]+\.(?:cpp|h|glsl|comp|vert|frag|py|sh|toml|\{h,cpp\}))`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
ROOTS = ("", "engine", "shaders", "tools", "tests")
TOPS = ("engine", "passes", "shaders", "tools", "tests", "assets", "docs")
# Files of a run or of an installation, not of the source.
MADE = re.compile(r"^(out|build|images|share|lib|\.\.|/)|^(frame_\d|results|report|session|frames)|://")
# Words that say a thing of the field in a private language; docs/glossary.md has the field's.
PRIVATE = re.compile(r"\b(auctions?|bidders?|dear(?! imgui)|dearest|mend(?:s|ed|ing)?|made-up|"
                     r"lets expect|anew|whoever|in vain|by name and all|t(?:akes?|ook|aking) turns)\b",
                     re.IGNORECASE)
READ = (".md", ".h", ".cpp", ".glsl", ".comp", ".vert", ".frag", ".py", ".sh", ".toml")
RESULT = re.compile(r"(?<![\w.])\d+\.\d+(?! ?%?<!--)(?![\w.])")


def expanded(path):
    """`a/b.{h,cpp}` is two paths."""
    match = re.search(r"\{([^}]*)\}", path)
    if not match:
        return [path]
    return [part for option in match[1].split(",")
            for part in expanded(path[:match.start()] + option + path[match.end():])]


def exists(page, path):
    folders = [page.parent, *(SOURCE / root for root in ROOTS)]
    if any(list(folder.glob(path.rstrip("/"))) for folder in folders):
        return True
    if "/" in path:
        # `n/a` and `GazePointX/Y` are no paths: they begin with no folder and end with no suffix.
        first, suffix = path.split("/")[0], re.search(r"\.\w+$", path)
        return not suffix and not any((folder / first).is_dir() for folder in folders)
    # The bare name of a file: somewhere in the source.
    return any(any((SOURCE / top).rglob(path)) for top in TOPS)


def paths_of(page, text):
    prose = re.sub(r"^```.*?^```$", "", text, flags=re.S | re.M)
    for path in PATH.findall(prose):
        if MADE.search(path) or "NAME" in path:
            continue
        for one in expanded(path):
            if not exists(page, one):
                yield f"{page.relative_to(SOURCE)}: `{one}` is not there"
    for link in LINK.findall(prose):
        target, _, anchor = link.partition("#")
        if "://" in link or link.startswith("mailto:"):
            continue
        file = (page.parent / target) if target else page
        if not file.exists():
            yield f"{page.relative_to(SOURCE)}: the link {link} leads nowhere"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file):
            yield f"{page.relative_to(SOURCE)}: {target} has no heading {anchor}"


def anchors(page):
    """As GitHub makes them of headings."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-") for heading in headings}


def unmarked(page, text):
    """Between <!-- results --> and <!-- /results --> every decimal number names its file."""
    for block in re.findall(r"<!-- results -->(.*?)<!-- /results -->", text, re.S):
        for number in RESULT.findall(re.sub(r"<!--.*?-->", "<!---->", block)):
            yield f"{page.relative_to(SOURCE)}: {number} among the results names no file"


def private_words():
    """Lines of documents, code and comments that use them; the list above is no such line."""
    faults = []
    for top in TOPS + ("README.md", "BENCHMARKS.md"):
        for file in sorted((SOURCE / top).rglob("*")) or [SOURCE / top]:
            if file.suffix not in READ or "vendor" in file.parts or file.name == "text_test.py":
                continue
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                if match := PRIVATE.search(line):
                    faults.append(f"{file.relative_to(SOURCE)}:{number}: '{match[0]}'")
    return faults


def check_comparison():
    """The comparison itself: it must be able to fail."""
    assert difference("a\nb", "a\nb") is None
    assert difference("a 1.5 ms", "a 2.5 ms") is None
    assert difference("a 1.5 dB", "a 2.5 dB") is not None
    assert difference("a 1.50 dB", "a 1.51 dB", near=True) is None
    assert difference("a 1.50 dB", "a 2.51 dB", near=True) is not None
    assert difference("a\n...\nz", "a\nb\nc\nz") is None
    assert difference("a\n...\ny", "a\nb\nc\nz") is not None
    assert difference("a", "a\nb") is not None


def main():
    check_comparison()
    faults = []
    count = 0
    for page in pages():
        if "vendor" in page.parts:
            continue  # the paths there are those of others
        text = page.read_text(encoding="utf-8")
        count += 1
        faults += paths_of(page, text)
        faults += unmarked(page, text)
    faults += private_words()
    for name, lines in LONGEST.items():
        length = len((SOURCE / name).read_text(encoding="utf-8").splitlines())
        if length > lines:
            faults.append(f"{name}: {length} lines, at most {lines}")
    current = subprocess.run([sys.executable, SOURCE / "tools" / "benchmarks.py", "--check"],
                             capture_output=True, text=True, check=False)
    if current.returncode != 0:
        faults.append("tools/benchmarks.py --check: " + current.stdout + current.stderr)
    for fault in faults:
        print("FAILED", fault)
    if faults:
        sys.exit(1)
    print(f"documents: {count} pages")


main()
