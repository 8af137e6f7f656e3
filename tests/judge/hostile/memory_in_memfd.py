"""Fills an anonymous file, which is memory that no process shows. Expect: MLE RTE"""

import os

fd = os.memfd_create("hidden")
for _ in range(1000):
    os.write(fd, bytes(1 << 20))
