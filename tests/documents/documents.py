"""What the tests of documents share: the documents, their fenced blocks, and how outputs compare."""
import os
import pathlib
import re

SOURCE = pathlib.Path(os.environ["MACULA_SOURCE"])
FENCE = re.compile(r"^(?P<before>(?:<!--[^\n]*-->\n)*)```(?P<info>[^\n]*)\n(?P<body>.*?)^```$", re.S | re.M)
TIME = re.compile(r"\d+(?:\.\d+)?(?= ms\b)")
NUMBER = re.compile(r"(?<![\w.])-?\d+\.\d+(?![\w.])")


def pages(*folders):
    """Every Markdown page of the source, or those in some of its folders; not what a build made."""
    found = [page for page in sorted(SOURCE.rglob("*.md"))
             if not {"build", ".git"} & set(page.relative_to(SOURCE).parts)]
    if not folders:
        return found
    return [page for page in found
            if page.parent == SOURCE or page.relative_to(SOURCE).parts[0] in folders]


def fences(text):
    """@returns (comments before, words behind the backticks, body) of each fenced block"""
    return [(match["before"], match["info"].split(), match["body"]) for match in FENCE.finditer(text)]


def alike(shown, printed, near):
    """Whether a line that a document shows is what was printed. Times in ms may differ; where `near`,
    other decimal numbers may differ by 5 % or one in the last place: rasterisers round differently."""
    if not near:
        return TIME.sub("#", shown) == TIME.sub("#", printed)
    left, right = TIME.sub("#", shown), TIME.sub("#", printed)
    if NUMBER.sub("#", left).split() != NUMBER.sub("#", right).split():
        return False
    for a, b in zip(NUMBER.findall(left), NUMBER.findall(right)):
        least = 10.0 ** -len(a.partition(".")[2])
        if abs(float(a) - float(b)) > max(0.05 * abs(float(a)), 1.01 * least):
            return False
    return True


def difference(shown, printed, near=False):
    """The first line of `shown` that `printed` lacks in its place, or None. `...` is any lines."""
    left, right = shown.splitlines(), printed.splitlines()
    at = 0
    anywhere = False
    for line in left:
        if line.strip() == "...":
            anywhere = True
            continue
        while anywhere and at < len(right) and not alike(line.rstrip(), right[at].rstrip(), near):
            at += 1
        if at >= len(right) or not alike(line.rstrip(), right[at].rstrip(), near):
            return f"shown: {line!r}, printed: {right[at] if at < len(right) else 'nothing'!r}"
        at += 1
        anywhere = False
    if at < len(right) and not anywhere:
        return f"printed, not shown: {right[at]!r}"
    return None
