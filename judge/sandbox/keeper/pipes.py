"""Serves the three pipes of a program without ever waiting for it."""

from __future__ import annotations

import os

STDERR_BYTES = 8192
BLOCK_BYTES = 1 << 16


class Feeder:
    """Feeds `head`, then a file, to a pipe. A program could overwrite a file that it was given."""

    def __init__(self, source: int, pipe: int, head: bytes = b"") -> None:
        self.fd = pipe
        self._source = source
        self._block = memoryview(head)
        self._open = True

    def feed(self) -> bool:
        """Write what fits; return whether there is more. At the end, close the pipe."""
        try:
            while block := self._block or memoryview(os.read(self._source, BLOCK_BYTES)):
                self._block = block
                self._block = block[os.write(self.fd, block) :]
        except BlockingIOError:
            return True
        except BrokenPipeError:  # the program has closed its input early
            pass
        self.close()
        return False

    def close(self) -> None:
        """Close the pipe; may be called more than once."""
        if self._open:
            os.close(self.fd)
            self._open = False


class Sink:
    """Writes at most `limit` bytes of standard output to a file; keeps the head of stderr."""

    def __init__(self, stdout: int, stderr: int, file: int, limit: int) -> None:
        self.open_fds = [stdout, stderr]
        self.written = 0
        self.stderr = b""
        self._file = file
        self._limit = limit

    def take(self, fd: int) -> bool:
        """Read once without waiting; return False at the end of the pipe."""
        try:
            block = os.read(fd, BLOCK_BYTES)
        except BlockingIOError:
            return True
        room = max(0, self._limit - self.written)
        self.written += len(block)
        if fd == self.open_fds[1]:
            self.stderr += block[: STDERR_BYTES - len(self.stderr)]
            return bool(block)
        rest = block[:room]
        while rest:  # one call may write only a part
            rest = rest[os.write(self._file, rest) :]
        return bool(block)

    def drain(self) -> None:
        """Read what is left in the pipes and close them. All writers must have ended.

        This does not wait for the end of a pipe: the kernel may still hold a writing end that
        was sent over a socket and never received.
        """
        for fd in self.open_fds:
            before = -1
            while before != self.written:
                before = self.written
                self.take(fd)
            os.close(fd)
        self.open_fds.clear()
