"""Control groups: where they can be made, what they count and limit, and that none is left."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from judge.kit.paths import ROOT
from judge.sandbox.facts import Facts, RunLimits, Stop
from judge.sandbox.keeper.cgroup import LEAF, SLACK_MIB, Cgroup, Cgroups
from judge.sandbox.keeper.protocol import Request, decode_reply, encode
from judge.sandbox.sandbox import Command, Sandbox
from judge.sandbox.wall import Wall

MOUNT = "41 31 0:38 {root} {place} rw,relatime - cgroup2 cgroup2 rw\n"
OTHER = "40 31 0:37 / /sys/fs/cgroup/cpu rw,relatime - cgroup cgroup rw,cpu\n"


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
    assert set(groups.places.values()) == {own}
    assert (own / "cgroup.subtree_control").read_text() == "+memory +pids"
    groups.close("none")
    assert [path.name for path in own.iterdir() if path.is_dir()] == []


def test_in_a_container_only_a_part_of_the_hierarchy_is_mounted(fake) -> None:
    process, own = fake(group="/machine/a/b", root="/machine/a")
    assert set(Cgroups(process).places.values()) == {own}
    assert own.name == "b"


@pytest.mark.parametrize("missing", ["mountinfo", "cgroup"])
def test_without_cgroup_v2_there_is_no_control_group(fake, missing: str) -> None:
    process, _ = fake()
    (process / missing).write_text("")
    assert Cgroups(process).places == {}
    (process / missing).unlink()
    assert Cgroups(process).places == {}


def test_where_no_control_group_can_be_made_nothing_changes(fake, monkeypatch) -> None:
    process, own = fake()
    monkeypatch.setattr("os.access", lambda *_: False)
    assert Cgroups(process).places == {}
    assert (own / "cgroup.subtree_control").read_text() == ""


@pytest.mark.parametrize("refused", [{1}, {1, 3}])  # then no controller is delegated
def test_a_process_alone_in_its_control_group_moves_below_and_back(
    fake, monkeypatch, refused: set[int]
) -> None:
    process, own = fake()
    (own / "cgroup.procs").write_text(f"{os.getpid()}\n")
    wrote: list[tuple[str, int | str]] = []

    def written(path: Path, value: int | str) -> bool:
        wrote.append((str(path.relative_to(own)), value))
        return len(wrote) not in refused

    monkeypatch.setattr("judge.sandbox.keeper.cgroup.written", written)
    groups = Cgroups(process)
    assert set(groups.places.values()) == ({own} if len(refused) == 1 else set())
    groups.close("none")
    assert wrote == [
        ("cgroup.subtree_control", "+memory +pids"),
        (f"{LEAF}/cgroup.procs", os.getpid()),
        ("cgroup.subtree_control", "+memory +pids"),
        ("cgroup.subtree_control", "-memory -pids"),
        ("cgroup.procs", os.getpid()),
    ]
    assert not (own / LEAF).exists()


def test_a_process_that_is_not_alone_changes_nothing(fake, monkeypatch) -> None:
    """Controllers cannot be enabled beside other processes, and those stay where they are."""
    process, own = fake()
    monkeypatch.setattr("judge.sandbox.keeper.cgroup.written", lambda *_: False)
    assert Cgroups(process).places == {}
    assert not (own / LEAF).exists()


OLD = "40 31 0:{n} / {place}/{name} rw,relatime - cgroup cgroup rw,{name}\n"


def test_version_1_has_a_place_for_each_controller(tmp_path: Path) -> None:
    process = tmp_path / "self"
    process.mkdir()
    names = ("memory", "pids", "cpuacct", "devices")
    mounts = "".join(OLD.format(n=n, place=tmp_path, name=name) for n, name in enumerate(names))
    unified = MOUNT.format(root="/", place=tmp_path / "unified")  # without controllers
    (process / "mountinfo").write_text(mounts + unified)
    (process / "cgroup").write_text("".join(f"{n}:{name}:/a\n" for n, name in enumerate(names)))
    for name in (*names, "unified"):
        (tmp_path / name / "a").mkdir(parents=True)
        (tmp_path / name / "a" / "cgroup.procs").touch()
    groups = Cgroups(process)
    assert groups.places == {
        "memory": tmp_path / "memory" / "a",
        "pids": tmp_path / "pids" / "a",
        "cpu": tmp_path / "cpuacct" / "a",
    }
    shutil.rmtree(tmp_path / "pids")
    assert Cgroups(process).places == {}  # two of three hold nobody


FILES = {
    2: {
        "memory.max": "max",
        "memory.swap.max": "max",
        "memory.current": f"{30 << 20}",
        "memory.stat": f"anon 1\nfile {20 << 20}\nshmem {5 << 20}\n",
        "memory.events": "max 9\noom 1\noom_kill 3\n",
        "pids.max": "max",
        "cpu.stat": "usage_usec 1500000\nuser_usec 1\n",
    },
    1: {
        "memory.limit_in_bytes": "9",
        "memory.memsw.limit_in_bytes": "9",
        "memory.usage_in_bytes": f"{30 << 20}",
        "memory.stat": f"cache 1\ntotal_cache {20 << 20}\ntotal_shmem {5 << 20}\n",
        "memory.oom_control": "oom_kill_disable 0\nunder_oom 0\noom_kill 3\n",
        "pids.max": "max",
        "cpuacct.usage": "1500000000\n",
    },
}


@pytest.mark.parametrize("version", FILES)
def test_what_a_keeper_reads_and_writes(tmp_path: Path, monkeypatch, version: int) -> None:
    mkdir = Path.mkdir

    def kernel_mkdir(path: Path, **options: bool) -> None:
        mkdir(path, **options)
        for name, text in {**FILES[version], "cgroup.procs": f"{os.getpid()}\n7\n8\n"}.items():
            if not (path / name).exists():
                (path / name).write_text(text)

    monkeypatch.setattr(Path, "mkdir", kernel_mkdir)
    own = tmp_path / f"g-{os.getpid()}"
    cgroup = Cgroup(dict.fromkeys(("memory", "pids", "cpu"), f"{tmp_path}/g"))
    assert (own / "cgroup.procs").read_text().startswith(str(os.getpid()))
    (own / "cgroup.procs").write_text(f"{os.getpid()}\n7\n8\n")
    cgroup.begin(memory_mib=100, processes=9)
    most = str((100 + 15 + int(SLACK_MIB)) << 20)  # 15 MiB are the keeper's own
    wrote = {name: (own / name).read_text()[: len(most)] for name in FILES[version]}
    if version == 2:
        assert (wrote["memory.max"], wrote["memory.swap.max"][0]) == (most, "0")
    else:
        limits = wrote["memory.limit_in_bytes"], wrote["memory.memsw.limit_in_bytes"]
        assert limits == (most, most)
    assert wrote["pids.max"].startswith("10")
    assert (cgroup.cpu_s(), cgroup.memory_mib(), cgroup.out_of_memory) == (0.0, 0.0, False)
    assert cgroup.processes() == 2
    used = "memory.current" if version == 2 else "memory.usage_in_bytes"
    (own / used).write_text(str(50 << 20))
    assert cgroup.memory_mib() == 20.0
    kills = "memory.events" if version == 2 else "memory.oom_control"
    (own / kills).write_text("oom_kill 4\n")
    assert cgroup.out_of_memory


@pytest.mark.parametrize("judge_lives", [True, False])
def test_after_a_killed_judge_keepers_remove_what_it_made(
    tmp_path: Path, monkeypatch, judge_lives: bool
) -> None:
    """Version 2: who enters its own control group again must first disable the controllers."""
    leaf, own = tmp_path / LEAF, tmp_path / f"g-{os.getpid()}"
    leaf.mkdir()
    own.mkdir()
    for directory in (leaf, own, tmp_path):
        (directory / "cgroup.procs").write_text("")
    control = tmp_path / "cgroup.subtree_control"
    control.write_text("memory pids  ")
    if judge_lives:
        (leaf / "cgroup.procs").write_text("1\n")
    cgroup = Cgroup({"memory": f"{tmp_path}/g"})
    removed: list[str] = []
    monkeypatch.setattr(Path, "rmdir", lambda path: removed.append(path.name))
    cgroup.close()
    assert control.read_text() == ("memory pids  " if judge_lives else "-memory -pids")
    assert (tmp_path / "cgroup.procs").read_text() == str(os.getpid())
    assert removed == [own.name, LEAF]  # the kernel refuses to remove one that is in use


def test_without_control_groups_nothing_is_counted(tmp_path: Path) -> None:
    # No kernel made the directory of the second one, so it has no cgroup.procs.
    places = dict.fromkeys(("memory", "pids", "cpu"), f"{tmp_path}/g")
    for cgroup in (Cgroup({}), Cgroup(places)):
        cgroup.begin(100, 9)
        assert not cgroup.there
        assert (cgroup.memory_mib(), cgroup.cpu_s()) == (0.0, 0.0)
        assert not cgroup.out_of_memory
        cgroup.close()
    assert list(tmp_path.iterdir()) == []


KERNEL_ENDS_IT = """
import os, sys
from judge.sandbox.keeper import watch
from judge.sandbox.keeper.cgroup import Cgroup
from judge.sandbox.keeper.protocol import decode_request, encode
Cgroup.out_of_memory = True
request = decode_request(sys.argv[1].encode())
os.write(1, encode(watch.run(request, None, Cgroup({}))))
"""


def test_a_program_that_the_kernel_kills_for_memory_is_over_the_limit(tmp_path: Path) -> None:
    request = Request(
        argv=(sys.executable, "-c", "import os; os.kill(os.getpid(), 9)"),
        **{"cwd": "/", "env": {}, "stdin": None, "stdout": f"{tmp_path}/out"},
        **{"wall": None, "user": None, "limits": RunLimits(9, memory_mib=64, output_mib=1)},
    )
    reader, writer = os.pipe()  # the keeper's control pipe: silent, but open
    done = subprocess.run(
        [sys.executable, "-c", KERNEL_ENDS_IT, encode(request).decode()],
        **{"stdin": reader, "stdout": subprocess.PIPE, "cwd": ROOT, "timeout": 60, "check": True},
    )
    os.close(reader)
    os.close(writer)
    facts = decode_reply(done.stdout)
    assert isinstance(facts, Facts)
    assert (facts.signal, facts.stopped, facts.memory_mib) == (9, Stop.MEMORY, 64 + SLACK_MIB)


@pytest.fixture
def real() -> Iterator[Cgroups]:
    """Where real control groups can be made."""
    groups = Cgroups()
    if not groups.places:
        pytest.skip("this user may make no control groups")
    yield groups
    groups.close("none")


def left(groups: Cgroups, name: str) -> list[str]:
    return [str(path) for place in groups.places.values() for path in place.glob(f"{name}*")]


@pytest.mark.parametrize("with_wall", [False, True])
def test_no_control_group_is_left(
    real: Cgroups, tmp_path: Path, wall: Wall, with_wall: bool
) -> None:
    script = "setsid sleep 60 & cat /proc/self/cgroup"
    limits = RunLimits(time_limit_s=5, memory_mib=200, output_mib=1)
    with Sandbox(wall if with_wall else None) as sandbox:
        name = sandbox.scratch.name
        facts = sandbox.run(Command(("/bin/sh", "-c", script)), limits, stdout=tmp_path / "out")
        assert left(real, name), "the keeper has none"
    assert facts.exit_status == 0
    assert left(real, name) == []
    assert (name in (tmp_path / "out").read_text()) is not with_wall  # a namespace hides the names


def test_what_a_killed_keeper_leaves_is_removed(real: Cgroups) -> None:
    for place in set(real.places.values()):
        (place / "collision-course-left-17").mkdir()
    Cgroups().close("collision-course-left")
    assert left(real, "collision-course-left") == []


HIDDEN = """
import os, signal, time
signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # children are reaped automatically
reader, writer = os.pipe()
if os.fork() == 0:
    end = time.process_time() + 0.3
    while time.process_time() < end:
        pass
    os.write(writer, b"x")
    os._exit(0)
os.read(reader, 1)
time.sleep(0.05)
"""


def test_cpu_time_that_no_accounting_sees_is_counted(real: Cgroups, run_bare) -> None:
    assert run_bare(HIDDEN).cpu_s >= 0.3
    assert run_bare("pass").cpu_s < 0.3  # the keeper and earlier runs do not count


SPREAD = """
import os, sys, time
reader, writer = os.pipe()
for _ in range(8):  # each for itself is small, and gone before anybody looks closely
    if os.fork() == 0:
        block = b"1" * (40 << 20)
        os.write(writer, b"x")
        time.sleep(1)
        os._exit(0)
for _ in range(8):
    os.read(reader, 1)
print("held")
"""


def test_the_kernel_holds_the_memory_of_all_processes(real: Cgroups, run_bare, tmp_path) -> None:
    facts = run_bare(SPREAD, memory_mib=128)
    assert facts.stopped is Stop.MEMORY
    assert (tmp_path / "out").read_text() == ""
    assert run_bare(SPREAD, memory_mib=600).exit_status == 0
    assert 280 < run_bare(SPREAD, memory_mib=600).memory_mib < 420


def test_caches_of_files_are_no_memory_of_the_program(real: Cgroups, run_bare, tmp_path) -> None:
    kind = ["stat", "-f", "-c", "%T", tempfile.gettempdir()]
    if subprocess.run(kind, capture_output=True, text=True, check=True).stdout == "tmpfs\n":
        pytest.skip("scratch files are in memory here")
    code = (
        "import os\n"
        "with open('big', 'wb') as file:\n"
        "    for _ in range(200): file.write(b'1' * (1 << 20))\n"
        "with open('big', 'rb') as file:\n"
        "    while file.read(1 << 20): pass\n"
        "print('done')\n"
    )
    facts = run_bare(code, memory_mib=64)
    assert (facts.exit_status, facts.stopped) == (0, None)
    assert facts.memory_mib < 64


def test_the_number_of_processes_is_limited(real: Cgroups, run_bare, tmp_path) -> None:
    code = (
        "import os, time\n"
        "made = 0\n"
        "try:\n"
        "    while made < 500:\n"
        "        if os.fork() == 0: time.sleep(5); os._exit(0)\n"
        "        made += 1\n"
        "except OSError: pass\n"
        "print(made, flush=True)\n"
    )
    run_bare(code, processes=32)
    assert int((tmp_path / "out").read_text() or 0) <= 32 + 4


def test_the_report_says_what_holds(walled_sandbox: Sandbox, uncounted_sandbox: Sandbox) -> None:
    counted = bool(Cgroups().places)
    said = str(walled_sandbox.protection)
    assert said.endswith("with seccomp and control groups") is counted
    uncounted = str(uncounted_sandbox.protection)
    figure = "without control groups (up to 500 MiB of kernel memory are not counted)"
    assert uncounted.endswith(figure)
    assert "500 MiB" in (ROOT / "docs" / "security.md").read_text()
