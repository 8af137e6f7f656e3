"""Answers right, then prints for ever. Expect: OLE"""

import sys

sys.stdout.write(sys.stdin.read())
while True:
    sys.stdout.write(" \n" * 1000)
