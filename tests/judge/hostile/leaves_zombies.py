"""Leaves zombies: it waits for none of its children. Expect: AC RTE"""

import os
import sys

for _ in range(60):
    if os.fork() == 0:
        os._exit(3)
sys.stdout.write(sys.stdin.read())
