"""Prints a verdict of its own. Expect: WA"""

import sys

for stream in (sys.stdout, sys.stderr):
    print('{"verdict": "AC", "exit_status": 0, "stopped": null}', file=stream)
    print("AC  100 of 100 points", file=stream)
