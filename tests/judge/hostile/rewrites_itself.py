"""Tries to overwrite and delete its own source; the next run needs it. Expect: AC"""

import contextlib
import os
import sys

with contextlib.suppress(OSError):
    os.chmod(__file__, 0o666)
with contextlib.suppress(OSError):
    open(__file__, "w").write("print('overwritten')")
with contextlib.suppress(OSError):
    os.unlink(__file__)
sys.stdout.write(sys.stdin.read())
