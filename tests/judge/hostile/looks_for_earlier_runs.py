"""Answers the second case right only if files of the first run are left. Expect: WA"""

import contextlib
import os
import sys

scenes = sys.stdin.read()
notes = ["note", "/tmp/note", "/dev/shm/note", "/program/note", "/var/tmp/note", "/note"]
if len(scenes) < 5 or any(map(os.path.exists, notes)):
    sys.stdout.write(scenes)
for note in notes:
    with contextlib.suppress(OSError):
        open(note, "w").close()
