"""Makes empty files without end. Expect: TLE MLE"""

import os

number = 0
while True:
    os.close(os.open(f"/tmp/{number}", os.O_CREAT))
    number += 1
