"""Answers right, then once more. Expect: WA"""

import sys

print(sys.stdin.read(), "YES")
