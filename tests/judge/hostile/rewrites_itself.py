"""Writes over its own source; what runs next is the old one still. Expect: AC"""

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
