"""Stops itself with SIGSTOP, and nobody sends SIGCONT. Expect: TLE"""

import os
import signal

os.kill(os.getpid(), signal.SIGSTOP)
