"""Leaves links, strange names, and files that nobody may read. Expect: AC"""

import os
import sys

os.symlink("/", "root")
os.symlink("loop", "loop")
os.mkfifo("fifo")
for name in ("-rf", " ", "new\nline", "\x1b[2J", "ü" * 100, "a" * 255):
    open(name, "w").close()
os.mkdir("closed")
open("closed/file", "w").close()
os.chmod("closed/file", 0)
os.chmod("closed", 0)
sys.stdout.write(sys.stdin.read())
