"""The verdicts, defined once for judging, declarations and reports."""

from __future__ import annotations

from enum import StrEnum


class Verdict(StrEnum):
    """The judgement of one run, one group or one whole judging."""

    AC = "AC"  # accepted
    WA = "WA"  # wrong answer
    TLE = "TLE"  # time limit exceeded
    RTE = "RTE"  # run-time error: an exit status other than 0, or a signal
    MLE = "MLE"  # memory limit exceeded
    OLE = "OLE"  # output limit exceeded
    CE = "CE"  # compile error
    JE = "JE"  # judge error: the judge failed, not the submission
