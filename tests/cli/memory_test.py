#!/usr/bin/env python3
"""Memory from outside: what a command holds at its start, and reading a large gaze log."""
import os
import resource
import subprocess
import sys
import tempfile

MACULA = sys.argv[1]
MIB = 1 << 20
LOG_BYTES = 60 * MIB
MOST_INFO = 64 * MIB  # whatever the length of the log
MOST_START = 32 * MIB  # of that, for the program itself; image libraries alone would be over
RATE_HZ = 1000
BLOCK_ROWS = 10000
LOST_EVERY = 50


def block(first):
    """Rows from number `first` on, as text."""
    rows = []
    for i in range(first, first + BLOCK_ROWS):
        if i % LOST_EVERY == 0:
            rows.append(f"{i / RATE_HZ:.3f},,,0\n")
        else:
            rows.append(f"{i / RATE_HZ:.3f},{0.2 + i % 601 / 1000:.6f},{0.3 + i % 401 / 1000:.6f},1\n")
    return "".join(rows)


def write_log(path):
    """A canonical log, block by block: the memory of this process counts as the child's least."""
    rows = 0
    with open(path, "w") as f:
        f.write("time_s,x,y,valid\n")
        while f.tell() < LOG_BYTES:
            f.write(block(rows))
            rows += BLOCK_ROWS
    return rows


def holds(path, word):
    """Whether the word stands in a file, read in parts (see write_log)."""
    with open(path, "rb") as f:
        before = b""
        while part := f.read(MIB):
            if word in before + part:
                return True
            before = part[-len(word):]
    return False


def run(most, *arguments):
    """Runs the program, checks the largest resident size of all children so far, gives its output."""
    done = subprocess.run([MACULA, *arguments], check=True, capture_output=True, text=True)
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
    print(f"macula {' '.join(arguments)}: {peak / MIB:.1f} MiB of {most / MIB:.0f}")
    assert peak <= most, f"{peak} bytes resident, {most} allowed"
    return done.stdout


def value(text, label):
    return next(line.split()[1] for line in text.splitlines() if line.split()[:1] == [label])


def main():
    if holds(MACULA, b"__asan_init"):
        print("skipped: sanitizers hold memory of their own")
        sys.exit(77)
    run(MOST_START, "--version")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "long.csv")
        rows = write_log(path)
        text = run(MOST_INFO, "gaze", "info", path)
        assert value(text, "samples") == str(rows), text
        assert value(text, "lost") == str(rows // LOST_EVERY), text
        assert value(text, "rate") == f"{RATE_HZ}.00", text
    print("memory: OK")


main()
