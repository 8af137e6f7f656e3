"""Fills memory that no process shows: an anonymous file. Expect: MLE RTE"""

import os

fd = os.memfd_create("hidden")
for _ in range(1000):
    os.write(fd, bytes(1 << 20))
