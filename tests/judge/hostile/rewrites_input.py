"""Tries to overwrite its own input, then answers right. Expect: AC WA"""

import os
import sys

scenes = sys.stdin.read()
for path in ("/proc/self/fd/0", "/dev/stdin"):
    try:
        fd = os.open(path, os.O_RDWR | os.O_NONBLOCK)
        os.ftruncate(fd, 0)
        os.write(fd, b"NO\n")
    except OSError:
        continue
sys.stdout.write(scenes)
