"""Opens pipes until that is refused, then answers right. Expect: AC"""

import os
import sys

try:
    while True:
        os.pipe()
except OSError:
    sys.stdout.write(sys.stdin.read())
