"""Runs the program on a terminal of its own and ends it by Ctrl-C: for tests."""
import os
import pty
import re
import signal
import subprocess


def interrupted(command, folder, after=1):
    """The exit status and what the terminal saw of a run that gets SIGINT when its bar says that so
    many steps are done."""
    ours, theirs = pty.openpty()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=theirs, cwd=folder) as run:
        os.close(theirs)
        seen, asked = "", False
        while True:
            try:
                part = os.read(ours, 4096).decode()
            except OSError:  # the other end is closed
                break
            seen += part
            done = re.findall(r"\] (\d+)/\d", seen)
            if not asked and done and int(done[-1]) >= after:
                run.send_signal(signal.SIGINT)
                asked = True
        os.close(ours)
    return run.returncode, seen
