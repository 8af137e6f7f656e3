"""A crash is told with the line of the source, the reason, and what signals mean."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from judge.languages.crash import compiler_lines, crash_reason, shown_stderr
from judge.languages.submission import compile_submission, from_source
from judge.languages.table import by_name
from judge.problem.declaration import load
from judge.run import run_input
from judge.sandbox.facts import RunLimits
from judge.sandbox.keeper.pipes import HEAD_BYTES, STDERR_BYTES, TAIL_BYTES, Pipes
from judge.sandbox.sandbox import Sandbox

LIMITS = RunLimits(time_limit_s=5.0, memory_mib=256, output_mib=1)
TRACEBACK = b"""\
Traceback (most recent call last):
  File "/x/submission.py", line 12, in <module>
    main()
  File "/x/submission.py", line 7, in main
    heapq.heappush(None, 1)
  File "/usr/lib/python3.11/heapq.py", line 3, in heappush
TypeError: heap argument must be a list
"""
JAVA = b"""\
Exception in thread "main" java.lang.NullPointerException
\tat java.base/java.util.Objects.requireNonNull(Objects.java:209)
\tat Robot.turn(Main.java:17)
\tat Robot.main(Main.java:3)
"""
CPP = b"""\
3 obstacles
terminate called after throwing an instance of 'std::out_of_range'
  what():  vector::_M_range_check: __n (which is 11) >= this->size() (which is 3)
"""
JAVASCRIPT = b"""\
/x/submission.js:2
console.log(x.y);
              ^

TypeError: Cannot read properties of undefined (reading 'y')
    at Object.<anonymous> (/x/submission.js:2:15)

Node.js v20.20.2
"""
RUST = b"""
thread 'main' (7) panicked at /x/submission.rs:3:5:
index out of bounds: the len is 3 but the index is 7
note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace
"""
GO = b"""\
panic: runtime error: index out of range [5]

goroutine 1 [running]:
main.main()
\t/x/submission.go:7 +0x1d
exit status 2
"""
SAID = [
    ("python", "submission.py", TRACEBACK, "line 7: TypeError: heap argument must be a list"),
    (
        "python",
        "submission.py",
        b'  File "/x/submission.py", line 3, in f\n  [Previous line repeated 996 more times]\n'
        b"RecursionError: maximum recursion depth exceeded\n",
        "line 3: RecursionError: maximum recursion depth exceeded "
        "(too many calls inside one another: the recursion is too deep)",
    ),
    (
        "java",
        "Main.java",
        JAVA,
        'line 17: Exception in thread "main" java.lang.NullPointerException',
    ),
    (
        "c++",
        "submission.cpp",
        CPP,
        "terminate called after throwing an instance of 'std::out_of_range' what(): "
        "vector::_M_range_check: __n (which is 11) >= this->size() (which is 3) "
        "(no part of the program catches this exception)",
    ),
    (
        "c++",
        "submission.cpp",
        b"submission: /x/submission.cpp:4: int main(): Assertion `c==5' failed.\n",
        "line 4: submission: /x/submission.cpp:4: int main(): Assertion `c==5' failed.",
    ),
    (
        "js",
        "submission.js",
        JAVASCRIPT,
        "line 2: TypeError: Cannot read properties of undefined (reading 'y')",
    ),
    (
        "rust",
        "submission.rs",
        RUST,
        "line 3: index out of bounds: the len is 3 but the index is 7",
    ),
    ("go", "submission.go", GO, "line 7: panic: runtime error: index out of range [5]"),
    ("python", "submission.py", b"a line\nthe last one\n", "the last one"),
    ("c++", "submission.cpp", b"\x1b[2J AC\n", r"\x1b[2J AC"),
]  # fmt: skip


@pytest.mark.parametrize(("language", "source", "stderr", "said"), SAID)
def test_the_line_and_the_reason(language: str, source: str, stderr: bytes, said: str) -> None:
    assert crash_reason(by_name(language), source, stderr) == said


def test_the_whole_standard_error_names_the_users_file() -> None:
    shown = shown_stderr(TRACEBACK + b"\x1b[2J\n", "submission.py", "my robot.py")
    assert 'File "my robot.py", line 7, in main' in shown
    assert shown.splitlines()[-1] == r"\x1b[2J"
    assert "/usr/lib/python3.11/heapq.py" in shown


RUN = [
    ("python", "def f(a):\n    return 1 // a\nf(0)\n", "exit status 1: line 2: ZeroDivision"),
    ("python", "def f(): f()\nf()\n", "recursion is too deep"),
    (
        "c++",
        "int main() { volatile int *p = 0; return *p; }",
        "segmentation fault (SIGSEGV): it read or wrote memory that is not its own "
        "(an index out of range, or too deep a recursion?)",
    ),
    (
        "c++",
        "int main() { volatile int a = 7, b = 0; return a / b; }",
        "arithmetic error (SIGFPE): an integer was divided by zero",
    ),
    (
        "c++",
        "#include <vector>\nint main(int c, char **) { return std::vector<int>(3).at(c + 10); }",
        "aborted (SIGABRT): terminate called after throwing an instance of 'std::out_of_range'",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("language", "code", "words"), RUN)
def test_a_real_crash(sandbox: Sandbox, language: str, code: str, words: str) -> None:
    if language == "c++" and shutil.which("g++") is None:
        pytest.skip("g++ is not installed")
    submission = from_source(code.encode(), "standard input", by_name(language))
    program = compile_submission(submission, load().limits, sandbox)
    assert words in run_input(sandbox, program, LIMITS, b"").judgement.message


@pytest.mark.parametrize(
    "size", [10, HEAD_BYTES + TAIL_BYTES, HEAD_BYTES + TAIL_BYTES + 1, 300_000]
)
def test_both_ends_of_standard_error_are_kept(size: int, tmp_path: Path) -> None:
    said = b"".join(b"%07d\n" % n for n in range(size // 8 + 1))[:size]
    read, write = os.pipe()
    os.set_blocking(read, False)
    with Path(os.devnull).open("rb") as source, (tmp_path / "out").open("wb") as file:
        pipes = Pipes(os.dup(write), os.dup(read), read, b"", source.fileno(), file.fileno(), 1)
        for start in range(0, size, 60_000):
            os.write(write, said[start : start + 60_000])
            pipes.serve(read)
        os.close(write)
        pipes.drain()
    if size <= HEAD_BYTES + TAIL_BYTES:
        assert pipes.stderr == said
        return
    left_out = size - HEAD_BYTES - TAIL_BYTES
    between = b"\n... %d bytes left out ...\n" % left_out
    assert pipes.stderr == said[:HEAD_BYTES] + between + said[-TAIL_BYTES:]
    assert len(pipes.stderr) <= STDERR_BYTES


def test_a_long_text_of_a_compiler_begins_with_the_first_error() -> None:
    before = [f"In file included from <x{n}>" for n in range(20)]
    after = ["a.cpp:3:5: error: 'y' was not declared", "    3 |     y;", "      |     ^"]
    assert compiler_lines("\n".join([*before, *after]).encode()).splitlines() == after
    short = [*before[:3], *after]
    assert compiler_lines("\n".join(short).encode()).splitlines() == short
    assert compiler_lines("\n".join(before).encode()).splitlines() == [*before[:12], "…"]
