"""Answers right only if it has inherited a descriptor. Expect: WA"""

import os
import sys

for fd in range(3, 1024):
    try:
        os.fstat(fd)
    except OSError:
        continue
    sys.stdout.write(sys.stdin.read())
    break
