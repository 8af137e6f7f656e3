"""The facts of runs: what is measured, what is stopped, and that nothing is left."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from judge.kit.paths import ROOT
from judge.sandbox.facts import RunLimits, Stop
from judge.sandbox.keeper import BOOT
from judge.sandbox.keeper.cgroup import Cgroup, Cgroups
from judge.sandbox.keeper.memory import Memory, proportional_mib
from judge.sandbox.keeper.pipes import Pipes
from judge.sandbox.keeper.proc import STATE, Process, fields, look_at
from judge.sandbox.keeper.tree import Tree
from judge.sandbox.sandbox import Command, Sandbox, SandboxError
from tests.judge.conftest import python_runner

if TYPE_CHECKING:
    from tests.judge.conftest import RunPython

LIMITS = RunLimits(time_limit_s=5, memory_mib=100, output_mib=1)


def running(mark: str) -> list[int]:
    """Return the processes whose command line holds `mark`."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if mark.encode() in (process / "cmdline").read_bytes():
                found.append(int(process.name))
        except OSError:
            continue
    return [pid for pid in found if pid != os.getpid()]


def test_exit_status_output_and_errors(run_python: RunPython, tmp_path: Path) -> None:
    facts = run_python("import os; os.write(1, b'out'); os.write(2, b'err'); os._exit(7)")
    assert (facts.exit_status, facts.signal, facts.stopped) == (7, None, None)
    assert (tmp_path / "out").read_bytes() == b"out"
    assert facts.stderr == b"err"
    assert facts.output_bytes == 6


def test_a_signal_is_not_an_exit_status(run_bare: RunPython) -> None:
    assert run_bare("import os; os.kill(os.getpid(), 11)").signal == 11
    by_choice = run_bare("import os; os._exit(139)")
    assert (by_choice.exit_status, by_choice.signal) == (139, None)


def test_stdin_is_a_pipe_and_cannot_be_overwritten(run_python: RunPython, tmp_path: Path) -> None:
    file = tmp_path / "in"
    file.write_bytes(b"line\n" * 100_000)
    code = (
        "import os, stat\n"
        "assert stat.S_ISFIFO(os.fstat(0).st_mode)\n"
        "os.write(1, str(len(open(0, 'rb').read())).encode())\n"
    )
    assert run_python(code, stdin=file).exit_status == 0
    assert (tmp_path / "out").read_bytes() == b"500000"
    assert file.read_bytes() == b"line\n" * 100_000


def test_unread_input_does_not_hang(run_python: RunPython, tmp_path: Path) -> None:
    file = tmp_path / "in"
    file.write_bytes(b"1" * (4 << 20))
    assert run_python("import os; os.close(0); os.write(1, b'x')", stdin=file).elapsed_s < 3


def test_cpu_time_is_that_of_the_program_not_of_the_wall(run_python: RunPython) -> None:
    code = "import time\nwhile time.process_time() < 0.4: pass\ntime.sleep(0.3)\n"
    facts = run_python(code)
    assert 0.38 < facts.cpu_s < 0.7
    assert facts.elapsed_s > 0.65


# A program waits until its pipe ends, with its last child: no sleep is long enough everywhere.
BURN = "import os, signal, time\nr, w = os.pipe()\n"
CHILDREN = {
    "waited-for": (
        "if os.fork() == 0:\n"
        "    while time.process_time() < 0.2: pass\n"
        "    os._exit(0)\n"
        "os.wait()\n"
    ),
    "orphan": (
        "if os.fork() == 0:\n"
        "    if os.fork() == 0:\n"
        "        while time.process_time() < 0.2: pass\n"
        "    os._exit(0)\n"
        "os.close(w)\n"
        "os.read(r, 1)\n"
    ),
    "reaped-automatically": (
        "signal.signal(signal.SIGCHLD, signal.SIG_IGN)\n"
        "for _ in range(4):\n"
        "    r, w = os.pipe()\n"
        "    if os.fork() == 0:\n"
        "        while time.process_time() < 0.075: pass\n"
        "        os._exit(0)\n"
        "    os.close(w)\n"
        "    os.read(r, 1)\n"
    ),
}


@pytest.mark.parametrize("name", CHILDREN)
def test_cpu_time_of_children_counts(run_python: RunPython, name: str) -> None:
    assert run_python(BURN + CHILDREN[name]).cpu_s > 0.175


def test_cpu_time_of_children_shorter_than_a_sample_stops_too(run_python: RunPython) -> None:
    code = "import os, time\nwhile True:\n    if os.fork() == 0:\n"
    code += "        while time.process_time() < 0.005: pass\n"
    code += "        os._exit(0)\n    os.wait()\n"
    # Nobody sees how long a child waited that has ended: a busy machine needs a longer limit.
    facts = run_python(code, time_limit_s=0.3, elapsed_s=30)
    assert facts.stopped is Stop.CPU
    assert facts.cpu_s > 0.3


def test_busy_loop_is_stopped_a_little_above_the_limit(run_python: RunPython) -> None:
    facts = run_python("while True: pass", time_limit_s=0.3)
    assert facts.stopped is Stop.CPU
    assert 0.5 < facts.cpu_s < 1.0


def test_ignored_signals_do_not_help(run_python: RunPython) -> None:
    code = (
        "import signal\n"
        "for s in set(signal.Signals) - {signal.SIGKILL, signal.SIGSTOP}: signal.signal(s, 1)\n"
        "while True: pass\n"
    )
    assert run_python(code, time_limit_s=0.2).stopped is Stop.CPU


def test_sleepers_are_ended_by_elapsed_time(sandbox: Sandbox, tmp_path: Path) -> None:
    facts = sandbox.run(
        Command(("/bin/sleep", "60")),
        RunLimits(time_limit_s=0.1, memory_mib=50, output_mib=1),
        stdin=None,
        stdout=tmp_path / "out",
    )
    assert facts.stopped is Stop.ELAPSED
    assert facts.cpu_s < 0.1
    assert 3 < facts.elapsed_s < 6


def test_memory_of_one_process(run_python: RunPython) -> None:
    # Long enough to be sampled on a busy machine, too.
    facts = run_python("import time\nx = b'1' * (90 << 20)\ntime.sleep(0.4)", memory_mib=200)
    assert facts.stopped is None
    assert 90 < facts.memory_mib < 120
    over = run_python("x = b'1' * (250 << 20)\nwhile True: pass", memory_mib=200)
    assert over.stopped is Stop.MEMORY
    assert over.memory_mib > 200


def test_memory_of_many_processes_is_summed_but_shared_pages_count_once(
    run_python: RunPython,
) -> None:
    own = "x = b'1' * (60 << 20)\n"
    shared = (
        "import os, time\n{}for _ in range(3):\n    if os.fork() == 0: break\n{}time.sleep(0.5)"
    )
    assert run_python(shared.format("", own), memory_mib=150).stopped is Stop.MEMORY
    facts = run_python(shared.format(own, ""), memory_mib=150)
    assert (facts.stopped, facts.memory_mib < 110) == (None, True)


@pytest.mark.parametrize(
    "run_python",
    [
        "uncounted_sandbox",
        pytest.param("sandbox", marks=pytest.mark.slow),
        pytest.param("walled_sandbox", marks=pytest.mark.slow),
    ],
    indirect=True,
)
def test_shared_pages_count_once_far_from_the_limit_too(run_python: RunPython) -> None:
    own = "x = b'1' * (60 << 20)\n"
    forks = "for _ in range(3):\n    if os.fork() == 0: break\n"
    shared, each = own + forks, forks + own
    for code, least_mib, most_mib in ((shared, 60, 110), (each, 240, 290)):
        code = f"import os, time\n{code}time.sleep(1)"
        assert least_mib < run_python(code, memory_mib=2000).memory_mib < most_mib


def test_a_mapped_file_in_scratch_counts_once(run_walled: RunPython) -> None:
    code = "import mmap, time\nf = open('/tmp/x', 'w+b')\nf.truncate(50 << 20)\n"
    code += "m = mmap.mmap(f.fileno(), 50 << 20)\nm[:] = bytes(50 << 20)\ntime.sleep(0.3)"
    assert run_walled(code, memory_mib=90).stopped is None
    assert run_walled(code, memory_mib=50).stopped is Stop.MEMORY


def sample_of(pid: int, resident_mib: float) -> Process:
    return Process(pid, "1", f"/nowhere/{pid + 10**8}", 0.0, 0.0, resident_mib)


def test_the_first_process_of_a_wall_counts_if_it_is_taken_over(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Both belong to the same user, so the program can write to its memory."""
    program = sample_of(3, 50)
    assert Memory({"/tmp": 1}).used_mib([sample_of(1, 3), sample_of(2, 3), program], 99) == 50
    monkeypatch.setattr(
        "judge.sandbox.keeper.memory.proportional_mib", lambda process, _: process.resident_mib
    )
    taken = Memory({"/tmp": 1}).used_mib([sample_of(1, 3), sample_of(2, 900), program], 2000)
    assert taken == 3 + 900 + 50
    assert Memory({}).used_mib([program], 99) == 50


def test_output_is_not_waited_for_when_all_processes_are_gone(tmp_path: Path) -> None:
    """A descriptor that was sent over a socket and never received keeps the pipe open."""
    unread, feed = os.pipe()
    out, held = os.pipe()
    err, closed = os.pipe()
    os.write(held, b"answer")
    os.close(closed)
    for fd in (feed, out, err):
        os.set_blocking(fd, False)
    with (tmp_path / "out").open("wb") as file:
        pipes = Pipes(feed, out, err, b"", unread, file.fileno(), 1 << 20)
        pipes.drain()
    for fd in (held, unread):
        os.close(fd)
    assert (tmp_path / "out").read_bytes() == b"answer"
    assert (pipes.open_fds, pipes.written) == ([], 6)
    for fd in (feed, out, err):
        with pytest.raises(OSError, match="Bad file"):
            os.fstat(fd)


def test_a_process_that_is_ending_holds_no_memory() -> None:
    """What it shares can no longer be read; to count all of it would be unfair to many workers."""
    pid = os.fork()
    if pid == 0:
        time.sleep(60)
        os._exit(0)
    alive = look_at(pid)
    assert alive is not None
    os.kill(pid, signal.SIGKILL)
    os.waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)
    assert (alive.resident_mib > 1, proportional_mib(alive, False)) == (True, 0.0)
    os.waitpid(pid, 0)
    assert (look_at(pid), proportional_mib(alive, False)) == (None, 0.0)


def test_memory_is_seen_when_the_first_thread_has_ended() -> None:
    code = "import ctypes, threading, time\nx = b'1' * (60 << 20)\n"
    code += "threading.Thread(target=time.sleep, args=(60,)).start()\nprint(flush=True)\n"
    code += "ctypes.CDLL(None).pthread_exit(None)"
    command = [sys.executable, "-c", code]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        assert process.stdout is not None
        process.stdout.readline()
        give_up = time.monotonic() + 30
        while fields(f"/proc/{process.pid}")[STATE] != "Z" and time.monotonic() < give_up:
            time.sleep(0.01)
        sample = look_at(process.pid)
        process.kill()
    assert sample is not None
    assert sample.place != f"/proc/{process.pid}"
    assert sample.resident_mib > 60


@pytest.mark.parametrize("descriptor", [1, 2])
def test_output_floods_are_stopped(run_python: RunPython, descriptor: int, tmp_path: Path) -> None:
    facts = run_python(f"import os\nwhile True: os.write({descriptor}, b'x' * 9999)")
    assert facts.stopped is Stop.OUTPUT
    assert (tmp_path / "out").stat().st_size <= 1 << 20
    assert len(facts.stderr) <= 8192


def test_an_orphan_that_holds_the_pipes_is_killed_not_waited_for(run_python: RunPython) -> None:
    mark = f"orphan-{os.getpid()}-{time.monotonic_ns()}"
    code = (
        "import os, sys\n"
        "if os.fork() == 0:\n"
        "    os.setsid()\n"
        "    if os.fork() == 0:\n"
        f"        sleep = 'import time; time.sleep(60) # {mark}'\n"
        "        os.execv(sys.executable, [sys.executable, '-c', sleep])\n"
        "    os._exit(0)\n"
        "os.wait()\n"
        "os.write(1, b'done')\n"
    )
    facts = run_python(code)
    assert facts.exit_status == 0
    assert facts.elapsed_s < 3
    assert running(mark) == []


def test_many_processes_are_stopped_and_none_is_left(run_python: RunPython) -> None:
    mark = f"many-{os.getpid()}-{time.monotonic_ns()}"
    code = (
        "import os, time\n"
        "for _ in range(6):\n"  # at most 64, and each of them stays alive
        "    try: os.fork()\n"
        "    except OSError: pass\n"  # no more are allowed
        f"time.sleep(30) # {mark}\n"
    )
    assert run_python(code, processes=20).stopped is Stop.PROCESSES
    assert running(mark) == []


@pytest.mark.parametrize("holding", [True, False])
def test_fewer_processes_where_kernel_memory_is_not_counted(
    holding: bool,
    walled_sandbox: Sandbox,
    uncounted_sandbox: Sandbox,
    tmp_path: Path,
) -> None:
    if holding and not Cgroups().places:
        pytest.skip("this user may make no control groups")
    code = "import os, time\nfor _ in range(45):\n    if os.fork() == 0: break\ntime.sleep(0.5)"
    run = python_runner(walled_sandbox if holding else uncounted_sandbox, tmp_path / "out")
    facts = run(code, processes=100, memory_mib=900)
    assert facts.stopped is (None if holding else Stop.PROCESSES)


def test_the_environment_and_descriptors_are_bare(run_python: RunPython, tmp_path: Path) -> None:
    code = "import os; print(sorted(os.environ), sorted(map(int, os.listdir('/proc/self/fd')))[:4])"
    for _ in range(3):  # the wall of the third one is built ahead
        assert run_python(code).exit_status == 0
        names, fds = (tmp_path / "out").read_text().strip().split("] ")
        # Python itself sets LC_CTYPE, and the shell that sets the limits inside sets PWD.
        assert set(re.findall(r"\w+", names)) - {"LC_CTYPE", "PWD"} == {"HOME", "TMPDIR"}
        assert fds == "[0, 1, 2, 3]"  # 3 is the directory being listed


def test_each_run_starts_in_an_empty_directory_of_its_own(
    run_python: RunPython, tmp_path: Path
) -> None:
    code = "import os; print(os.listdir()); open('left', 'w'); os.mkdir('d'); os.chmod('d', 0)"
    for _ in range(2):
        assert run_python(code).exit_status == 0
        assert (tmp_path / "out").read_text() == "[]\n"


def test_whatever_a_program_leaves_is_removed(run_bare: RunPython, sandbox: Sandbox) -> None:
    code = (
        "import os\n"
        "os.makedirs('closed/inner')\n"
        "os.chmod('closed/inner', 0)\n"
        "os.chmod('closed', 0)\n"
        "for _ in range(1500):\n"
        "    os.mkdir('deeper')\n"
        "    os.chdir('deeper')\n"
    )
    assert run_bare(code).exit_status == 0
    assert list(sandbox.scratch.glob("run-*")) == []


def test_a_program_that_does_not_exist(sandbox: Sandbox, tmp_path: Path) -> None:
    with pytest.raises(SandboxError, match=r"/no/such: .*No such file"):
        sandbox.run(Command(("/no/such",)), LIMITS, stdin=None, stdout=tmp_path / "out")
    facts = sandbox.run(Command(("/bin/true",)), LIMITS, stdin=None, stdout=tmp_path / "out")
    assert facts.exit_status == 0


def test_closing_leaves_no_file_and_no_process() -> None:
    with Sandbox() as sandbox:
        sandbox.run(Command(("/bin/true",)), LIMITS, stdin=None, stdout=sandbox.scratch / "out")
        scratch = sandbox.scratch
        assert running(str(scratch))
    assert not scratch.exists()
    assert running(str(scratch)) == []
    with pytest.raises(SandboxError, match="ended"):
        sandbox.run(Command(("/bin/true",)), LIMITS, stdin=None, stdout=scratch / "out")


def test_a_killed_judge_leaves_nothing(tmp_path: Path) -> None:
    """SIGKILL in the middle of a run: the keeper ends the program and removes the files."""
    mark = f"killed-{os.getpid()}-{time.monotonic_ns()}"
    code = (
        "import sys\n"
        "from pathlib import Path\n"
        "from judge.sandbox.sandbox import *\n"
        "from judge.sandbox.facts import RunLimits\n"
        "box = Sandbox()\n"
        f"command = Command((sys.executable, '-c', 'while True: pass # {mark}'))\n"
        "limits = RunLimits(time_limit_s=60, memory_mib=100, output_mib=1)\n"
        "box.run(command, limits, stdin=None, stdout=box.scratch / 'out')\n"
    )
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    env = {**os.environ, "TMPDIR": str(scratch)}
    with subprocess.Popen(
        [sys.executable, "-c", code], env=env, cwd=Path(__file__).parents[2]
    ) as p:
        give_up = time.monotonic() + 20
        # The judge's own code holds the mark, too, but does not end with it.
        while not running(f"{mark}\0") and time.monotonic() < give_up:
            time.sleep(0.02)
        assert len(running(f"{mark}\0")) == 1
        p.kill()
    while (running(mark) or list(scratch.iterdir())) and time.monotonic() < give_up:
        time.sleep(0.02)
    assert running(mark) == []
    assert list(scratch.iterdir()) == []


def test_no_place_for_scratch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "none"))
    with pytest.raises(SandboxError, match=r"none: no scratch space: No such file"):
        Sandbox()


@pytest.mark.slow
def test_waiting_for_a_processor_is_not_sleep(run_bare: RunPython) -> None:
    """On a seventh of a processor, it passes the elapsed limit while it is below the time limit."""
    processor = min(os.sched_getaffinity(0))
    pinned = f"import os\nos.sched_setaffinity(0, {{{processor}}})\n"
    busy = [
        subprocess.Popen(
            [sys.executable, "-c", pinned + "while True: pass"], start_new_session=True
        )
        for _ in range(6)
    ]
    try:
        code = pinned + "import time\nwhile time.process_time() < 0.9: pass\n"
        facts = run_bare(code, time_limit_s=1.0)
    finally:
        for process in busy:
            process.kill()
            process.wait()
    limits = RunLimits(time_limit_s=1.0, memory_mib=1, output_mib=1)
    assert facts.elapsed_s > limits.kill_elapsed_s, "it did not wait: the test shows nothing"
    assert (facts.stopped, facts.exit_status) == (None, 0)


@pytest.mark.skipif(os.getuid() != 0, reason="only root has something to drop")
def test_root_runs_a_program_as_nobody_where_nobody_can_reach_it(
    sandbox: Sandbox, tmp_path: Path
) -> None:
    # Where root judges without a wall, as in a container, a program must not own the machine.
    script = "id -u; touch here && ls; touch /etc/not-yours 2>/dev/null || echo refused"
    limits = RunLimits(time_limit_s=5, memory_mib=200, output_mib=1)
    facts = sandbox.run(Command(("/bin/sh", "-c", script)), limits, stdout=tmp_path / "out")
    assert facts.exit_status == 0
    user, *others = (tmp_path / "out").read_text().split()
    assert int(user) >= 65534
    assert others == ["here", "refused"]


def test_a_keeper_killed_at_its_start_leaves_no_directory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr("judge.sandbox.keepers.BOOT", "import os; os.kill(os.getpid(), 9)")
    lost = pytest.raises(SandboxError, match="the keeper of the run was lost")
    with lost, Sandbox() as sandbox:
        sandbox.run(Command(("/bin/true",)), LIMITS, stdout=tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_waiting_for_the_keeper_is_not_starvation(monkeypatch: pytest.MonkeyPatch) -> None:
    """A program with many processes to sample causes that work, and waits for its processor."""
    tree = Tree({}, Cgroup({}))
    ready_ns = int(9e9)
    monkeypatch.setattr("judge.sandbox.keeper.tree.descendants", lambda: [1, 2])
    monkeypatch.setattr("judge.sandbox.keeper.tree.read", lambda _path: f"1 {ready_ns} 1")
    assert 8.5 < tree.starved_s() <= 9.0
    while time.process_time() - tree._own_began_s < 0.2:
        pass
    assert 8.3 < tree.starved_s() <= 8.8


def test_shared_memory_is_measured_bit_by_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    exact_mib = {1: 50.0, 2: 10.0, 3: 400.0}
    looked: list[int] = []
    clock = iter(range(1000))

    def exact(process: Process, _without_scratch: bool) -> float:
        looked.append(process.pid)
        return exact_mib[process.pid]

    monkeypatch.setattr("judge.sandbox.keeper.memory.proportional_mib", exact)
    monkeypatch.setattr("judge.sandbox.keeper.memory.distinct", list)
    memory = Memory({})
    assert (memory.used_mib([sample_of(1, 300)], 500), looked) == (300.0, [])
    assert (memory.used_mib([sample_of(1, 300)], 200), looked) == (50.0, [1])
    pair = [sample_of(1, 300), sample_of(2, 300)]
    assert (memory.used_mib(pair, 700), looked[1:]) == (60.0, [1, 2])
    # A sample that takes long measures one process; the next one goes on with the others.
    monkeypatch.setattr("judge.sandbox.keeper.memory.time.monotonic", lambda: next(clock) * 0.003)
    three = [*pair, sample_of(3, 450)]
    assert (memory.used_mib(three, 500), looked[3:]) == (450.0, [1])  # a lower bound
    assert (memory.used_mib(three, 500), looked[3:]) == (450.0, [1, 2])
    assert (memory.used_mib(three, 500), looked[3:]) == (460.0, [1, 2, 3])
    assert memory.used_mib(three, 500) == 450.0  # all are measured again


def test_a_keeper_whose_judge_died_at_once_removes_the_scratch_directory(tmp_path: Path) -> None:
    places = json.dumps({})
    (tmp_path / "scratch" / "run-1").mkdir(parents=True)
    done = subprocess.run(
        [sys.executable, "-I", "-S", "-c", BOOT, ROOT, tmp_path / "scratch", places],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert list(tmp_path.iterdir()) == []
