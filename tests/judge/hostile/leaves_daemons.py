"""Leaves daemons in sessions of their own that hold its output open. Expect: AC"""

import os
import sys
import time

for _ in range(4):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            time.sleep(20)
        os._exit(0)
    os.wait()
sys.stdout.write(sys.stdin.read())
