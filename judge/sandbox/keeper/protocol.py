"""The messages between the judge and a keeper: one JSON array per line.

They are named tuples because the module `dataclasses` would make the keeper several MiB larger,
and with it the smallest peak memory that can be measured.
"""

from __future__ import annotations

import json
from enum import StrEnum
from typing import Any, NamedTuple


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


class CgroupRequest(NamedTuple):
    """Where a control group can be made.

    place: the beginning of its path. limits: whether controllers can limit memory or
    processes there.
    """

    place: str
    limits: bool


class Request(NamedTuple):
    """One run of one program.

    cwd: the directory it starts in, as the program sees it. drop: whether to change from root
    to an unprivileged user; a wall always does. stdin: a file to feed through a pipe; None:
    empty input. stdout: a file to write. The rest are limits; file_mib: the size of any file
    that the program writes.
    """

    argv: tuple[str, ...]
    env: dict[str, str]
    cwd: str
    drop: bool
    wall: WallRequest | None
    cgroup: CgroupRequest | None
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
    stderr: the first few KiB of standard error.
    """

    exit_status: int | None
    signal: int | None
    cpu_s: float
    elapsed_s: float
    memory_mib: float
    output_bytes: int
    stopped: Stop | None
    stderr: bytes = b""


class Failure(NamedTuple):
    """Why a run could not be made; the program is not to blame."""

    why: str


def encode_request(request: Request) -> bytes:
    """Return the request as one line."""
    return json.dumps(request).encode() + b"\n"


def decode_request(line: bytes) -> Request:
    """Return what `encode_request` was given."""
    request = Request(*json.loads(line))
    wall, cgroup = request.wall, request.cgroup
    return request._replace(
        wall=None if wall is None else WallRequest(*wall),
        cgroup=None if cgroup is None else CgroupRequest(*cgroup),
    )


def encode_reply(reply: Facts | Failure | None) -> bytes:
    """Return the reply as one line. None: ready, the keeper's first reply."""
    content: list[Any] = [] if reply is None else list(reply)
    if isinstance(reply, Facts):
        content[-1] = reply.stderr.decode("latin-1")  # each byte becomes one character
    return json.dumps(content).encode() + b"\n"


def decode_reply(line: bytes) -> Facts | Failure | None:
    """Return what `encode_reply` was given."""
    content = json.loads(line)
    if not content:
        return None
    if len(content) == 1:
        return Failure(*content)
    reply = Facts(*content)
    return reply._replace(
        stopped=None if reply.stopped is None else Stop(reply.stopped),
        stderr=content[-1].encode("latin-1"),
    )
