"""Prints terminal escape sequences. Expect: WA"""

import sys

sys.stdout.buffer.write(b"\x1b[2J\x1b[H\x9b2J\rAC")
