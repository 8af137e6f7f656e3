"""Answers right only if a descriptor was left open to it. Expect: WA"""

import os
import sys

for fd in range(3, 1024):
    try:
        os.fstat(fd)
    except OSError:
        continue
    sys.stdout.write(sys.stdin.read())
    break
