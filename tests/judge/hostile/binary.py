"""Prints every byte there is, zero first. Expect: WA"""

import sys

sys.stdout.buffer.write(bytes(range(256)))
