"""Forks sleepers, one after another. By itself it ends soon. Expect: RTE TLE"""

import os
import time

for _ in range(200):
    if os.fork() == 0:
        time.sleep(10)
        os._exit(0)
    time.sleep(0.005)
time.sleep(10)
