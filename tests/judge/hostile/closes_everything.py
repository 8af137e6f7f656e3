"""Closes every descriptor, then does nothing. Expect: WA"""

import os

os.closerange(0, 100)
