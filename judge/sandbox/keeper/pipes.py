"""Serves the three pipes of a program without ever waiting for it."""

from __future__ import annotations

import contextlib
import os

STDERR_BYTES = 8192  # of both ends, and what stands between them
HEAD_BYTES, TAIL_BYTES = 4096, 4032
BLOCK_BYTES = 1 << 16


class Pipes:
    """Feeds a file to a program's standard input, and takes its output and errors.

    stdin, stdout, stderr: our ends, non-blocking. head: what is fed before the file `source`,
    which the program could overwrite if it was given the file itself. sink: the file that
    receives at most `limit` bytes of the output. Of the errors, both ends are kept.
    """

    def __init__(
        self, stdin: int, stdout: int, stderr: int, head: bytes, source: int, sink: int, limit: int
    ) -> None:
        self.open_fds = [stdin, stdout, stderr]
        self.written = 0
        self._first = self._last = b""
        self._left_out = 0  # bytes of standard error between them
        self._stdin, self._stderr = stdin, stderr
        self._unsent = memoryview(head)
        self._source, self._sink, self._limit = source, sink, limit

    @property
    def stderr(self) -> bytes:
        """The beginning and the end of standard error: a crash may be explained at either."""
        between = b"\n... %d bytes left out ...\n" % self._left_out if self._left_out else b""
        return self._first + between + self._last

    def serve(self, fd: int) -> bool:
        """Feed what fits, or read once; at the end of a pipe, close it and return False."""
        more = True
        try:
            more = self._feed() if fd == self._stdin else self._take(fd)
        except BrokenPipeError:  # the program has closed its input early
            more = False
        except BlockingIOError:
            pass
        if not more:
            os.close(fd)
            self.open_fds.remove(fd)
        return more

    def drain(self) -> None:
        """Read what is left in the pipes and close them. All writers must have ended.

        This does not wait for the end of a pipe: the kernel may still hold a writing end that
        was sent over a socket and never received.
        """
        for fd in self.open_fds:
            with contextlib.suppress(BlockingIOError):
                while fd != self._stdin and self._take(fd):
                    pass
            os.close(fd)
        self.open_fds.clear()

    def _feed(self) -> bool:
        """Write until the end of the file. Raises BlockingIOError, BrokenPipeError."""
        while block := self._unsent or memoryview(os.read(self._source, BLOCK_BYTES)):
            self._unsent = block
            self._unsent = block[os.write(self._stdin, block) :]
        return False

    def _take(self, fd: int) -> bool:
        """Read once; return False at the end of the pipe. Raises BlockingIOError."""
        block = os.read(fd, BLOCK_BYTES)
        room = max(0, self._limit - self.written)
        self.written += len(block)
        if fd == self._stderr:
            room = HEAD_BYTES - len(self._first)
            self._first += block[:room]
            rest = self._last + block[room:]
            self._last = rest[-TAIL_BYTES:]
            self._left_out += len(rest) - len(self._last)
        else:
            rest = block[:room]
            while rest:  # one call may write only a part
                rest = rest[os.write(self._sink, rest) :]
        return bool(block)
