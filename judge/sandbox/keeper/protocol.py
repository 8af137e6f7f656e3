"""The messages between the judge and a keeper: one JSON value per line.

They are named tuples because the module `dataclasses` would make the keeper several MiB larger,
and with it the smallest peak memory that can be measured.
"""

from __future__ import annotations

import json
from enum import StrEnum
from typing import NamedTuple

UNLISTED_PROCESSES = 32  # each may hold memory of the kernel that only a control group counts


class Stop(StrEnum):
    """The limit for which the keeper stopped a run."""

    CPU = "cpu"
    ELAPSED = "elapsed"
    MEMORY = "memory"
    OUTPUT = "output"
    PROCESSES = "processes"


class WallRequest(NamedTuple):
    """How to build the wall around a program.

    bwrap: the path of bubblewrap. args: its arguments besides the binds. binds: source,
    destination, and whether the program may write there. scratch: the program's own memory
    file systems, by place, with their sizes in bytes. seccomp: the system-call filter in
    hexadecimal.
    """

    bwrap: str
    args: tuple[str, ...]
    binds: tuple[tuple[str, str, bool], ...]
    scratch: dict[str, int]
    seccomp: str


class Request(NamedTuple):
    """One run of one program.

    cwd: where it starts, as the program sees it. user: whom root becomes to run it, None to
    stay. stdin: a file that is fed through a pipe, None for an empty one; stdout: a file to
    write. The rest are the limits at which the program is ended; file_mib: of the largest file
    that it may write.
    """

    argv: tuple[str, ...]
    env: dict[str, str]
    cwd: str
    user: int | None
    wall: WallRequest | None
    stdin: str | None
    stdout: str
    kill_cpu_s: float
    kill_elapsed_s: float
    memory_mib: int
    output_bytes: int
    processes: int
    file_mib: int


class Facts(NamedTuple):
    """The facts about one run.

    exit_status, signal: of the program itself; exactly one of them is None.
    cpu_s: user and system seconds of the whole process tree; elapsed_s: from launch
    to end; memory_mib: the largest sum of resident memory seen over the tree;
    output_bytes: what it wrote to standard output and standard error;
    stopped: the limit for which it was stopped, None if it ended by itself;
    stderr: the first few KiB of standard error; all_ended: no process of it is left. One
    that dies slowly has no more say, but the keeper that waited for it takes no more requests.
    """

    exit_status: int | None
    signal: int | None
    cpu_s: float
    elapsed_s: float
    memory_mib: float
    output_bytes: int
    stopped: Stop | None
    stderr: bytes = b""
    all_ended: bool = True


def encode(message: Request | Facts | str) -> bytes:
    """Return a message as one line. A text replies why a run could not be made."""
    return json.dumps(message, default=_characters).encode() + b"\n"


def decode_request(line: bytes) -> Request:
    """Return the encoded request."""
    request = Request(*json.loads(line))
    return request._replace(wall=request.wall and WallRequest(*request.wall))


def decode_reply(line: bytes) -> Facts | str:
    """Return the encoded reply."""
    content = json.loads(line)
    if isinstance(content, str):
        return content
    stopped, stderr, _ = content[-3:]
    return Facts(*content)._replace(
        stopped=stopped and Stop(stopped), stderr=stderr.encode("latin-1")
    )


def _characters(data: bytes) -> str:
    """Return bytes as text: each one becomes one character."""
    return data.decode("latin-1")
