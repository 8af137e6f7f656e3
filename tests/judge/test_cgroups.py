"""Control groups: where they can be made, what they count and limit, and that none is left."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from threading import Thread
from types import SimpleNamespace

import pytest

from judge.kit.paths import ROOT
from judge.sandbox.cgroups import LEAF, Cgroups
from judge.sandbox.facts import Facts, RunLimits, Stop
from judge.sandbox.keeper.cgroup import SLACK_MIB, Cgroup
from judge.sandbox.keeper.launch import place_of_cgroup
from judge.sandbox.keeper.protocol import CgroupRequest, Request, decode_reply, encode_request
from judge.sandbox.probe import probe
from judge.sandbox.sandbox import Command, Sandbox

MOUNT = "41 31 0:38 {root} {place} rw,relatime - cgroup2 cgroup2 rw\n"
OTHER = "40 31 0:37 / /sys/fs/cgroup/cpu rw,relatime - cgroup cgroup rw,cpu\n"
CONTROLS = ("memory.max", "memory.swap.max", "memory.oom.group", "pids.max", "cgroup.procs")


@pytest.fixture
def fake(tmp_path: Path):
    """Imitate a mounted cgroup v2 and the /proc/self of a process in one of its control groups."""

    def make(group: str = "/a", root: str = "/") -> tuple[Path, Path]:
        place, process = tmp_path / "cgroup", tmp_path / "self"
        own = place / Path(group).relative_to(root)
        own.mkdir(parents=True)
        process.mkdir()
        (process / "mountinfo").write_text(OTHER + MOUNT.format(root=root, place=place))
        (process / "cgroup").write_text(f"4:memory:/elsewhere\n0::{group}\n")
        (own / "cgroup.controllers").write_text("cpu memory pids\n")
        (own / "cgroup.subtree_control").write_text("")
        (own / "cgroup.procs").write_text("1\n2\n")
        return process, own

    return make


def test_a_process_finds_its_own_control_group(fake) -> None:
    process, own = fake()
    groups = Cgroups(process)
    assert groups.directory == own
    assert (own / "cgroup.subtree_control").read_text() == "+memory +pids"
    groups.close("none")
    assert [path.name for path in own.iterdir() if path.is_dir()] == []


def test_in_a_container_only_a_part_of_the_hierarchy_is_mounted(fake) -> None:
    process, own = fake(group="/machine/a/b", root="/machine/a")
    assert Cgroups(process).directory == own
    assert own.name == "b"


@pytest.mark.parametrize("missing", ["mountinfo", "cgroup"])
def test_without_cgroup_v2_there_is_no_control_group(fake, missing: str) -> None:
    process, _ = fake()
    (process / missing).write_text("")
    assert Cgroups(process).directory is None
    (process / missing).unlink()
    assert Cgroups(process).directory is None


def test_where_no_control_group_can_be_made_nothing_changes(fake, monkeypatch) -> None:
    process, own = fake()

    def refuse(*_arguments: object, **_options: object) -> None:
        raise PermissionError

    monkeypatch.setattr(Path, "mkdir", refuse)
    assert Cgroups(process).directory is None
    assert (own / "cgroup.subtree_control").read_text() == ""


def test_a_process_alone_in_its_control_group_moves_below_and_back(fake, monkeypatch) -> None:
    process, own = fake()
    (own / "cgroup.procs").write_text(f"{os.getpid()}\n")
    wrote: list[tuple[str, str]] = []
    write_text = Path.write_text

    def write(path: Path, text: str) -> int:
        wrote.append((str(path.relative_to(own)), text))
        if len(wrote) == 1:
            raise OSError("processes are in here")
        return write_text(path, text)

    monkeypatch.setattr(Path, "write_text", write)
    groups = Cgroups(process)
    groups.close("none")
    assert wrote == [
        ("cgroup.subtree_control", "+memory +pids"),
        (f"{LEAF}/cgroup.procs", str(os.getpid())),
        ("cgroup.subtree_control", "+memory +pids"),
        ("cgroup.subtree_control", "-memory -pids"),
        ("cgroup.procs", str(os.getpid())),
    ]


def test_a_program_is_put_in_a_control_group_with_its_limits(tmp_path: Path, monkeypatch) -> None:
    mkdir = Path.mkdir

    def kernel_mkdir(path: Path) -> None:
        mkdir(path)
        for name in CONTROLS:
            (path / name).touch()

    monkeypatch.setattr(Path, "mkdir", kernel_mkdir)
    group = Cgroup(f"{tmp_path}/g", 17, memory_mib=100, processes=9)
    wrote = [(tmp_path / "g" / name).read_text() for name in CONTROLS]
    assert wrote == [str(116 << 20), "0", "1", "9", "17"]
    assert (group.cpu_s(), group.out_of_memory) == (0.0, False)
    (tmp_path / "g/cpu.stat").write_text("usage_usec 1500000\nuser_usec 1\n")
    (tmp_path / "g/memory.events").write_text("max 9\noom 1\noom_kill 0\n")
    assert (group.cpu_s(), group.out_of_memory) == (1.5, False)
    (tmp_path / "g/memory.events").write_text("max 9\noom 1\noom_kill 2\n")
    assert group.out_of_memory


def test_a_control_group_that_is_refused_leaves_nothing(tmp_path: Path) -> None:
    # The kernel did not make this directory, so it has no cgroup.procs to write to.
    group = Cgroup(f"{tmp_path}/g", 17, memory_mib=100, processes=9)
    assert list(tmp_path.iterdir()) == []
    group.kill()
    group.close()
    assert (group.cpu_s(), group.out_of_memory) == (0.0, False)


KERNEL_ENDS_IT = """
import os, sys
from judge.sandbox.keeper import watch
from judge.sandbox.keeper.cgroup import Cgroup
from judge.sandbox.keeper.protocol import decode_request, encode_reply
Cgroup.out_of_memory = True
os.write(1, encode_reply(watch.run(decode_request(sys.argv[1].encode()))))
"""


def test_a_program_that_the_kernel_kills_for_memory_is_over_the_limit(tmp_path: Path) -> None:
    request = Request(
        argv=(sys.executable, "-c", "import os; os.kill(os.getpid(), 9)"),
        **{"cwd": "/", "env": {}, "stdin": None, "stdout": f"{tmp_path}/out"},
        **{"kill_cpu_s": 9, "kill_elapsed_s": 9, "memory_mib": 64, "output_bytes": 9},
        **{"processes": 64, "file_mib": 1, "wall": None, "cgroup": None, "drop": False},
    )
    reader, writer = os.pipe()  # the keeper's control pipe: silent, but open
    done = subprocess.run(
        [sys.executable, "-c", KERNEL_ENDS_IT, encode_request(request).decode()],
        **{"stdin": reader, "stdout": subprocess.PIPE, "cwd": ROOT, "timeout": 60, "check": True},
    )
    os.close(reader)
    os.close(writer)
    facts = decode_reply(done.stdout)
    assert isinstance(facts, Facts)
    assert (facts.signal, facts.stopped, facts.memory_mib) == (9, Stop.MEMORY, 64 + SLACK_MIB)


@pytest.fixture
def real() -> Iterator[Path]:
    """The directory where real control groups can be made."""
    groups = Cgroups()
    if groups.directory is None:
        pytest.skip("this user may make no control groups")
    yield groups.directory
    groups.close("none")


UNSEEN = """
import os, signal, sys, time
sys.stdin.readline()
signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # children are reaped automatically
reader, writer = os.pipe()
if os.fork() == 0:
    os.setsid()
    while time.process_time() < 0.2:
        pass
    os.write(writer, b"x")
    time.sleep(60)
os.read(reader, 1)
"""


def test_a_real_control_group_counts_and_ends_a_daemon(real: Path) -> None:
    process = subprocess.Popen([sys.executable, "-c", UNSEEN], stdin=subprocess.PIPE)
    directory = real / f"{LEAF}-test-{process.pid}"
    group = Cgroup(str(directory), process.pid, memory_mib=64, processes=8)
    process.communicate(b"\n", timeout=60)
    assert group.cpu_s() >= 0.2
    left = (directory / "cgroup.procs").read_text().split()
    assert len(left) == 1  # the daemon
    group.kill()
    give_up = time.monotonic() + 30
    while (directory / "cgroup.procs").read_text() and time.monotonic() < give_up:
        time.sleep(0.01)
    group.close()
    assert not directory.exists()


def test_the_control_groups_of_a_killed_keeper_are_removed(real: Path) -> None:
    groups = Cgroups()
    assert groups.directory is not None
    left = groups.directory / "collision-course-left-17"
    left.mkdir()
    groups.close("collision-course-left")
    assert not left.exists()


@pytest.mark.parametrize("walled", [False, True])
@pytest.mark.parametrize("granted", [False, True])
@pytest.mark.parametrize("limits", [False, True])
def test_a_control_group_is_made_where_it_adds_something(
    walled: bool, granted: bool, limits: bool
) -> None:
    clock = SimpleNamespace(granted=granted)
    wall = "a wall" if walled else None
    request = SimpleNamespace(wall=wall, cgroup=CgroupRequest("/groups/name", limits))
    nothing_to_gain = walled and granted and not limits
    place = place_of_cgroup(request, clock)  # type: ignore[arg-type] # all that it uses of a clock
    assert place == (None if nothing_to_gain else f"/groups/name-{os.getpid()}")
    request.cgroup = None
    assert place_of_cgroup(request, clock) is None  # type: ignore[arg-type] # as above


@pytest.mark.parametrize("wall", [False, True])
def test_no_control_group_is_left_after_a_run(real: Path, tmp_path: Path, wall: bool) -> None:
    script = "setsid sleep 60 & cat /proc/self/cgroup"
    limits = RunLimits(time_limit_s=5, memory_mib=200, output_mib=1)
    with Sandbox(probe().wall if wall else None) as sandbox:
        facts = sandbox.run(Command(("/bin/sh", "-c", script)), limits, stdout=tmp_path / "out")
        assert list(real.glob(f"{sandbox.scratch.name}*")) == []
    assert facts.exit_status == 0
    own = [x for x in (tmp_path / "out").read_text().splitlines() if x.startswith("0::")]
    assert own == (["0::/"] if wall else own)  # behind a wall, a namespace hides the name
    assert wall or sandbox.scratch.name in own[0]


def test_delegated_controllers_limit_memory_and_processes(real: Path, tmp_path: Path) -> None:
    """Delegate them by `systemd-run --user --scope -p Delegate=yes python -m pytest ...`."""
    limits = RunLimits(time_limit_s=5, memory_mib=64, output_mib=1, processes=20)
    held: dict[str, str] = {}

    def look(name: str) -> None:
        give_up = time.monotonic() + 30
        while held.get("pids.max", "max") == "max" and time.monotonic() < give_up:  # not set yet
            for group in real.glob(f"{name}-*"):
                for file in ("memory.max", "pids.max"):
                    with contextlib.suppress(OSError):
                        held[file] = (group / file).read_text().strip()

    with Sandbox() as sandbox:
        request = sandbox._cgroups.request(sandbox.scratch.name)
        if request is None or not request.limits:
            pytest.skip("no controllers are delegated to this user")
        watcher = Thread(target=look, args=(sandbox.scratch.name,))
        watcher.start()
        sandbox.run(Command(("/bin/sleep", "0.5")), limits, stdout=tmp_path / "out")
        watcher.join()
        code = "import os\nfor _ in range(8): os.fork()\nwhile True: x = b'1' * (3 << 20)"
        command = Command((sys.executable, "-c", code))
        over = sandbox.run(command, limits, stdout=tmp_path / "out")
    assert held == {"memory.max": str((64 + SLACK_MIB) << 20), "pids.max": "80"}
    assert over.stopped in (Stop.MEMORY, Stop.PROCESSES)
