"""Answers right only if it finds an answer file anywhere. Expect: WA"""

import os

places = [f"/{name}" for name in os.listdir("/") if name not in ("usr", "proc", "bin", "lib")]
places += [f"/proc/{pid}/{link}" for pid in (1, "self") for link in ("cwd", "root/data", "fd")]
for place in places:
    for folder, _, names in os.walk(place):
        for name in names:
            if name.endswith(".ans"):
                print(open(os.path.join(folder, name)).read())
                raise SystemExit
