"""Prints a byte now and then, for ever. Expect: TLE"""

import time

while True:
    print(end=" ", flush=True)
    time.sleep(0.02)
