"""The messages between the judge and a keeper: one JSON value per line."""

from __future__ import annotations

import json
from typing import NamedTuple

from judge.sandbox.facts import Facts, RunLimits, Stop


class WallRequest(NamedTuple):
    """How to build the wall around a program.

    bwrap: the path of bubblewrap; args: its arguments. staged: what root binds below STAGE
    first, as 0, 1, ... scratch: the program's own memory file systems, by place, with their
    sizes in bytes. seccomp: the system-call filter in hexadecimal.
    """

    bwrap: str
    args: tuple[str, ...]
    staged: tuple[str, ...]
    scratch: dict[str, int]
    seccomp: str


class Request(NamedTuple):
    """One run of one program.

    cwd: where it starts, as the program sees it. user: whom root becomes to run it, None to
    stay. stdin: a file that is fed through a pipe, None for an empty one; stdout: a file to
    write.
    """

    argv: tuple[str, ...]
    env: dict[str, str]
    cwd: str
    user: int | None
    wall: WallRequest | None
    stdin: str | None
    stdout: str
    limits: RunLimits


def encode(message: Request | Facts | str) -> bytes:
    """Return a message as one line. A text replies why a run could not be made."""
    return json.dumps(message, default=lambda data: data.decode("latin-1")).encode() + b"\n"


def decode_request(line: bytes) -> Request:
    """Return the encoded request."""
    request = Request(*json.loads(line))
    wall = request.wall and WallRequest(*request.wall)
    return request._replace(wall=wall, limits=RunLimits(*request.limits))


def decode_reply(line: bytes) -> Facts | str:
    """Return the encoded reply."""
    content = json.loads(line)
    if isinstance(content, str):
        return content
    stopped, stderr, _ = content[-3:]
    return Facts(*content)._replace(
        stopped=stopped and Stop(stopped), stderr=stderr.encode("latin-1")
    )
