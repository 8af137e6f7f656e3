"""Ends at once; an orphan would answer later. Expect: WA"""

import os
import sys
import time

if os.fork() == 0:
    time.sleep(0.5)
    sys.stdout.write(sys.stdin.read())
