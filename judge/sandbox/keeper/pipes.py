"""Serves the three pipes of a program without ever waiting for it."""

from __future__ import annotations

import contextlib
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
        self._stderr_fd = stderr
        self._file = file
        self._limit = limit

    def take(self, fd: int) -> bool:
        """Read once without waiting; return whether more may come. Closes `fd` at its end."""
        try:
            more = self._read(fd)
        except BlockingIOError:
            return True
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
                while self._read(fd):
                    pass
            os.close(fd)
        self.open_fds.clear()

    def _read(self, fd: int) -> bool:
        """Read once; return False at the end of the pipe. Raises BlockingIOError."""
        block = os.read(fd, BLOCK_BYTES)
        self.written += len(block)
        if fd == self._stderr_fd:
            self.stderr += block[: STDERR_BYTES - len(self.stderr)]
        else:
            rest = block[: max(0, self._limit - self.written + len(block))]
            while rest:  # one call may write only a part
                rest = rest[os.write(self._file, rest) :]
        return bool(block)
