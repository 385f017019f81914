#!/usr/bin/env python3
"""tools/benchmarks.py refuses what cannot be measured again, and notices numbers that are not the files'."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["MACULA_SOURCE"])
POINT = ('{"schema": 1, "title": "One", "commit": "COMMIT", "date": "2026-01-01", "interrupted": false,'
         '"provenance": {"command": "macula chart one --out chart"}, "warm_up_rounds": 3,'
         '"gl": {"renderer": "r", "version": "v", "time_source": "t"},'
         '"machine": {"processor": "p", "cores": 2}, "points": [{"rounds": 3}], "targets": ['
         '{"name": "fast", "papers": "", "metric": "rmse", "study": "s", "where": "smoke 8x8, share 0.3",'
         '"value": 2.5, "limit": "<= 2", "state": "STATE", "reason": null, "note": ""}]}')


class Copy:
    """A tree with the tool, its own results, and one document; a repository where asked for."""

    def __init__(self, folder):
        self.root = pathlib.Path(folder)
        (self.root / "docs" / "benchmarks").mkdir(parents=True)
        (self.root / "tools").mkdir()
        for name in ("benchmarks.py", "benchmark_files.py"):
            shutil.copy(SOURCE / "tools" / name, self.root / "tools")
        self.note('[unmeasured]\ntext = ""\n')
        (self.root / "README.md").write_text("No number.\n", encoding="utf-8")
        self.git("init", "-q")
        self.git("add", "README.md")
        self.git("-c", "user.name=t", "-c", "user.email=t@t", "commit", "-q", "-m", "one")
        self.commit = self.git("rev-parse", "HEAD").strip()[:12]

    def git(self, *arguments):
        return subprocess.run(["git", "-C", self.root, *arguments], check=True, text=True,
                              capture_output=True).stdout

    def note(self, text):
        (self.root / "docs" / "benchmarks" / "notes.toml").write_text(text, encoding="utf-8")

    def results(self, commit, state="met"):
        run = self.root / "run"
        run.mkdir(exist_ok=True)
        text = POINT.replace("COMMIT", commit).replace("STATE", state)
        json.loads(text)
        (run / "results.json").write_text(text, encoding="utf-8")
        header = (SOURCE / "docs" / "benchmarks" / "quick.csv").read_text(encoding="utf-8")
        columns = next(line for line in header.splitlines() if line.startswith("study,"))
        row = ",".join("2.5" if "ms." in column or column == "rmse" else "8"
                       for column in columns.split(","))
        (run / "results.csv").write_text(f"{columns}\n{row}\n{row}\n", encoding="utf-8")
        return ["--from", str(run), "one"]

    def run(self, *arguments):
        """@returns the message of a refusal; empty where all went well"""
        done = subprocess.run([sys.executable, self.root / "tools" / "benchmarks.py", *arguments],
                              text=True, capture_output=True, check=False)
        assert (done.returncode == 0) == (not done.stderr), done.stderr
        return done.stderr


def main():
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(folder)
        assert "commit the changes" in copy.run(*copy.results("0123456789ab-dirty"))
        assert "no ancestor" in copy.run(*copy.results("0123456789ab"))
        assert not (copy.root / "docs" / "benchmarks" / "one.csv").exists(), "something was written"
        assert "not explained" in copy.run(*copy.results(copy.commit, "missed"))
        copy.note('[one]\nfast = "It is slow."\n[unmeasured]\ntext = ""\n')
        assert not copy.run(*copy.results(copy.commit, "missed"))
        page = (copy.root / "BENCHMARKS.md").read_text(encoding="utf-8")
        assert "It is slow." in page and "**2.5**" in page, page

        document = copy.root / "README.md"
        marker = '<!--one.claims.csv claim=fast : median-->'
        document.write_text(f"It is 9.9{marker} times.\n", encoding="utf-8")
        assert "run tools/benchmarks.py" in copy.run("--check")
        assert not copy.run()
        assert document.read_text(encoding="utf-8") == f"It is 2.5{marker} times.\n"
        assert not copy.run("--check")
        document.write_text("It is 2.5<!--one.csv study=8 : speed--> times.\n", encoding="utf-8")
        assert "2 rows" in copy.run("--check")
        document.write_text("It is 2.5<!--one.csv nothing=8 : speed--> times.\n", encoding="utf-8")
        assert "no column 'nothing'" in copy.run("--check")
    print("benchmarks: OK")


main()
