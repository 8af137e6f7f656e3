"""Answers right, then ends with a status other than 0. Expect: RTE"""

import sys

sys.stdout.write(sys.stdin.read())
sys.exit(3)
