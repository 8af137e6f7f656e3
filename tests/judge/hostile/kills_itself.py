"""Answers right, then kills itself, also when it is repeated. Expect: RTE"""

import os
import signal
import sys

sys.stdout.write(sys.stdin.read())
sys.stdout.flush()
os.kill(os.getpid(), signal.SIGKILL)
