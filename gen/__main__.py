"""`python -m gen`."""

import sys

from gen.cli import main

sys.exit(main(sys.argv[1:]))
