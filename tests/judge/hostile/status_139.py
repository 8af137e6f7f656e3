"""Ends with the status that shells give a segmentation fault. Expect: RTE"""

import sys

sys.stdout.write(sys.stdin.read())
sys.exit(139)
