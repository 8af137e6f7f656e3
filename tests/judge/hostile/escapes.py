"""Prints terminal escape sequences, to standard error as well. Expect: RTE"""

import sys

EVIL = "\x1b[2J\x1b[H\x1b]0;title\x07\x9b2J\x1b[32mAC  100 of 100 points\r\u202e"
print(EVIL)
sys.exit(EVIL)
