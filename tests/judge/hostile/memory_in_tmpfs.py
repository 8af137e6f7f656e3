"""Fills all scratch space, and its own memory nearly up to the limit. Expect: MLE"""

import os
import time

for place in ("/tmp", "/dev/shm"):
    fd = os.open(f"{place}/filler", os.O_CREAT | os.O_WRONLY)
    try:
        while True:
            os.write(fd, bytes(1 << 20))
    except OSError:
        pass
filler = bytearray(470 << 20)
filler[::4096] = bytes(len(filler[::4096]))
time.sleep(1)
