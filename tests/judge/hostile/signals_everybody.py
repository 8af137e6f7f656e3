"""Stops and kills every process that it can, then answers right. Expect: AC"""

import os
import signal
import sys

own = {os.getpid()}
for number in (signal.SIGSTOP, signal.SIGKILL):
    for pid in {-1, os.getppid(), *range(1, 400)} - own:
        try:
            os.kill(pid, number)
        except OSError:
            continue  # nobody there, or not ours to signal
sys.stdout.write(sys.stdin.read())
