"""The committed result files, docs/benchmarks/*.csv: written from a run, read, and quoted.

A file begins with lines `# key: value` that say how it was measured; a CSV table follows. NAME.csv
holds the measured points, NAME.claims.csv how the claims of the experiment came out.

A document quotes a number by writing a marker behind it:

    2.7<!--quick.csv study=table2 scene=bottles light=unlit variant=kb-plus : ms.total-->

The file, the cells that select one row, a colon, and a column. `A / key=value` divides by the same
column of the row that differs in these cells. In a file of claims, `median`, `least` and `most` are of
column `value` over all selected rows, and `met` and `rows` count them. The text in front is compared
with the file's number at as many decimals as the text has; `%` behind the number means hundredths.
"""
import csv
import io
import pathlib
import re
import shlex
import statistics

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "docs" / "benchmarks"
MARKER = re.compile(r"(?P<number>-?\d+(?:\.\d+)?)(?P<percent> ?%)?<!--(?P<what>[\w.-]+\.csv .*?)-->")
STATISTICS = {"median": statistics.median, "least": min, "most": max}


class BenchmarkError(Exception):
    """What a person can repair: names the file and what is wrong with it."""


def write(path, about, columns, rows):
    """Writes a result file. @param about key to text, the lines above the table: how it was measured"""
    if about.get("commit", "").endswith("-dirty"):
        raise BenchmarkError(f"{path}: measured by changed sources; commit the changes, build, and measure again")
    text = io.StringIO()
    for key, value in about.items():
        text.write(f"# {key}: {value}\n")
    table = csv.DictWriter(text, columns, lineterminator="\n", extrasaction="ignore")
    table.writeheader()
    table.writerows(rows)
    path.write_text(text.getvalue(), encoding="utf-8")


def read(name, folder=FOLDER):
    """@returns what stands above the table, and its rows"""
    path = folder / name
    if not path.is_file():
        raise BenchmarkError(f"{path}: there is no such result file; see docs/benchmarks/README.md")
    about, lines = {}, []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("# ") and not lines:
            key, _, value = line[2:].partition(": ")
            about[key] = value
        else:
            lines.append(line)
    return about, list(csv.DictReader(lines))


def select(name, rows, cells):
    """The rows whose cells are these; a column that is not there is an error."""
    for key in cells:
        if key not in rows[0]:
            raise BenchmarkError(f"{name}: there is no column '{key}'")
    return [row for row in rows if all(row[key] == value for key, value in cells.items())]


def one(name, rows, cells):
    found = select(name, rows, cells)
    if len(found) != 1:
        raise BenchmarkError(f"{name}: {len(found)} rows are {cells}, not one")
    return found[0]


def number_in(name, row, column):
    text = row.get(column)
    if not text:
        raise BenchmarkError(f"{name}: column '{column}' is empty or missing there")
    return float(text)


def evaluate(what, folder=FOLDER):
    """The number that a marker's text names."""
    head, colon, tail = what.partition(" : ")
    if not colon:
        raise BenchmarkError(f"{what}: a marker is FILE KEY=VALUE... : COLUMN")
    name, *pairs = shlex.split(head)
    cells = dict(pair.split("=", 1) for pair in pairs)
    column, *divisor = shlex.split(tail)
    _, rows = read(name, folder)
    if column in STATISTICS or column in ("met", "rows"):
        rows = select(name, rows, cells)
        if column == "rows":
            return float(len(rows))
        if column == "met":
            return float(sum(row["state"] == "met" for row in rows))
        values = [float(row["value"]) for row in rows if row["value"] and row["state"] != "n/a"]
        if not values:
            raise BenchmarkError(f"{what}: no row has a value")
        return STATISTICS[column](values)
    value = number_in(name, one(name, rows, cells), column)
    if divisor:
        other = {**cells, **dict(pair.split("=", 1) for pair in divisor[1:])}
        value /= number_in(name, one(name, rows, other), column)
    return value


def corrected(match, folder=FOLDER):
    """The text of a marked number as the file has it, marker and all."""
    number, percent, what = match["number"], match["percent"] or "", match["what"]
    decimals = len(number.partition(".")[2])
    value = evaluate(what, folder) * (100.0 if percent else 1.0)
    return f"{value:.{decimals}f}{percent}<!--{what}-->"


def documents():
    """README and everything in docs/ that is text."""
    return [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
