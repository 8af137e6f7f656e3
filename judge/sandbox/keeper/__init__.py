"""The keeper: launches programs one at a time, watches their processes and kills them all.

It is a process of its own (`BOOT`). It is small, because a child's peak memory starts at its
parent's. It is single-threaded, because a death signal is sent when the launching *thread*
ends. It is a child subreaper, because only such a process sees the CPU time of processes that
outlive their parents. It imports little of the standard library, and of `judge` only `facts`.
"""

BOOT = (
    "import sys; sys.path.insert(0, sys.argv[1]); "
    "from judge.sandbox.keeper.serve import main; main()"
)
