"""Answers right only if it learns of the judge or its user. Expect: WA"""

import os
import sys

seen = " ".join(os.environ.values()) + os.getcwd()
for name in ("environ", "cmdline"):
    for pid in (1, os.getppid(), "self"):
        try:
            seen += open(f"/proc/{pid}/{name}").read()
        except OSError:
            continue
words = ("checker", "keeper", "secret", "collision", "LOGNAME", "SSH")
if any(word in seen for word in words):
    sys.stdout.write(sys.stdin.read())
