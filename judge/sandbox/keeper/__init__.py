"""The keeper: launches programs one at a time, watches their processes, ends them all.

Its own process (`BOOT`), small and single-threaded on purpose: a child's peak memory
starts at its parent's, a death signal fires when the launching *thread* ends, and only
a child subreaper sees the CPU time of processes that outlive their parents. It imports
little of the standard library and nothing else of `judge`.
"""

BOOT = (
    "import sys; sys.path.insert(0, sys.argv[1]); "
    "from judge.sandbox.keeper.serve import main; main()"
)
