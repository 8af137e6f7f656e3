"""Sleeps for ever. Expect: TLE"""

import time

time.sleep(1e6)
