"""Makes a file of a terabyte that holds nothing. Expect: RTE"""

import os

os.truncate(os.open("sparse", os.O_CREAT | os.O_WRONLY), 1 << 40)
