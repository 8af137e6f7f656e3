"""Fills all scratch space, then answers right. Expect: AC"""

import os
import sys

for place in ("/tmp", "/dev/shm"):
    fd = os.open(f"{place}/filler", os.O_CREAT | os.O_WRONLY)
    try:
        while True:
            os.write(fd, bytes(1 << 20))
    except OSError:
        pass
sys.stdout.write(sys.stdin.read())
