#!/usr/bin/env python3
"""Tosses a coin for every scenario."""

import random
import sys

t = int(sys.stdin.readline())
coin = random.Random(t)
print("\n".join(coin.choice(("YES", "NO")) for _ in range(t)))
