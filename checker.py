#!/usr/bin/env python3
"""Judges a submission: compiles, runs, limits, compares, scores. More than an output validator.

    ./checker.py SUBMISSION        ./checker.py < my.py        ./checker.py --help

Any Python 3 may start it: outside the kit's own environment it hands over to that.
What it does stands in judge/; its command line in judge/cli.py; stress/front.py adds --explain.
"""

from judge.kit.door import start

if __name__ == "__main__":
    start("stress.front", "checker.py")
