"""Leaves directories nested too deep for any path. Expect: AC"""

import os
import sys

for _ in range(3000):
    os.mkdir("deeper")
    os.chdir("deeper")
sys.stdout.write(sys.stdin.read())
