"""Answers right, then kills itself, twice if it must. Expect: RTE"""

import os
import signal
import sys

sys.stdout.write(sys.stdin.read())
sys.stdout.flush()
os.kill(os.getpid(), signal.SIGKILL)
