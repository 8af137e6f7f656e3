"""Mishaps of real users: odd files, closed streams, full disks, foreign conventions."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from judge.kit.files import write_whole
from judge.kit.paths import ROOT
from judge.languages.guess import guess
from judge.languages.java import java_names
from judge.languages.submission import LONGEST_SOURCE_BYTES, from_source, read_submission
from judge.problem.cases import CasesError, find_cases
from judge.problem.declaration import load

ECHO = "import sys\nsys.stdout.write(sys.stdin.read())\n"


def run(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, ROOT / "checker.py", *arguments, "--time-limit", 3, "--no-wall"]
    settings: dict[str, object] = {"stderr": subprocess.PIPE, "text": True, "timeout": 60}
    return subprocess.run(list(map(str, command)), **{**settings, **options})


def test_a_relative_data_directory(data: Path, source) -> None:
    done = run(source("e.py", ECHO), "--data", data.name, cwd=data.parent, stdout=subprocess.PIPE)
    assert done.returncode == 0, done.stderr
    assert "partial: not all of the kit's cases" in done.stdout


@pytest.mark.parametrize("content", ["", " \n\n"])
def test_an_empty_answer_file_is_an_error(data: Path, content: str) -> None:
    (data / "secret/small/02.ans").write_text(content)
    with pytest.raises(CasesError, match=r"02\.ans: expected answers, found an empty file"):
        find_cases(data, load())


def test_a_case_name_cannot_move_the_cursor_or_break_the_json(data: Path, source) -> None:
    for name in (b"\x1b[31m", b"a\nAC", b"\xff"):
        for ending, text in ((b".in", b"YES\n"), (b".ans", b"YES\n")):
            with open(os.path.join(os.fsencode(data), name + ending), "wb") as file:  # noqa: PTH118, PTH123 (bytes)
                file.write(text)
    report = data.parent / "r.json"
    done = run(source("e.py", ECHO), "--data", data, "--json", report, stdout=subprocess.PIPE)
    assert done.returncode == 0, done.stderr
    assert "\x1b" not in done.stdout
    assert not any(
        line.startswith("AC") and "MiB" not in line for line in done.stdout.splitlines()[:-1]
    )
    assert report.read_text().count("sample/01") == 1


def test_a_report_never_replaces_what_is_no_report(data: Path, source, tmp_path: Path) -> None:
    program = source("e.py", ECHO)
    done = run(program, "--data", data, "--json", program)
    assert (done.returncode, program.read_text()) == (2, ECHO)
    assert "expected a file of its own, found the submission" in done.stderr
    done = run(program, "--data", data, "--json", tmp_path / "r", "--junit", tmp_path / "r")
    assert "expected a file of its own, found the file of --json" in done.stderr
    done = run(program, "--data", data, "--json", tmp_path)
    assert "expected a file, found a directory" in done.stderr


def test_a_report_follows_links_and_feeds_pipes(tmp_path: Path) -> None:
    target, link, pipe = tmp_path / "target", tmp_path / "link", tmp_path / "pipe"
    target.write_text("old")
    link.symlink_to(target)
    write_whole(link, b"new")
    assert (link.is_symlink(), target.read_text()) == (True, "new")
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    write_whole(pipe, b"through")
    assert os.read(reader, 100) == b"through"
    os.close(reader)
    assert pipe.is_fifo()


def test_a_full_disk_and_a_lost_reader_are_judge_errors(data: Path, source) -> None:
    program = source("e.py", ECHO)
    with Path("/dev/full").open("w") as full:
        done = run(program, "--data", data, stdout=full)
    assert done.returncode == 2
    assert done.stderr == "checker.py: standard output: No space left on device\n"
    reader, writer = os.pipe()
    os.close(reader)
    done = run(program, "--data", data, stdout=writer)
    os.close(writer)
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
    with Path("/dev/full").open("w") as full:
        assert run(data / "none.py", stderr=full).returncode == 2


@pytest.fixture
def tiny(tmp_path: Path) -> Iterator[Path]:
    """A file system of 24 KiB for scratch files."""
    place = tmp_path / "tiny"
    place.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=24k", "tmpfs", place]
    if subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("this user may not mount a file system")
    yield place
    subprocess.run(["umount", place], check=True)


@pytest.mark.parametrize(
    ("name", "text", "where", "message"),
    [
        ("loud.py", "print('YES ' * 9000)", "stdout", "/stdout: No space left on device"),
        (
            "big.cpp",
            "char a[1 << 16] = {1}; int main() { return a[0]; }",
            "stderr",
            "no scratch space: expected 1024 KiB, found ",
        ),
    ],
)
def test_a_full_scratch_space_is_blamed_on_nobody_else(
    data: Path, source, tiny: Path, name: str, text: str, where: str, message: str
) -> None:
    if name.endswith(".cpp") and shutil.which("g++") is None:
        pytest.skip("g++ is not installed")
    path = source(name, text)
    done = run(path, "--data", data, env={**os.environ, "TMPDIR": tiny}, stdout=subprocess.PIPE)
    assert done.returncode == 2
    assert message in getattr(done, where)
    assert list(tiny.iterdir()) == []


@pytest.mark.parametrize(("closed", "status"), [("<&-", 2), (">&-", 0)])
def test_closed_streams(data: Path, source, closed: str, status: int) -> None:
    program = "" if closed == "<&-" else source("e.py", ECHO)
    command = f"'{sys.executable}' '{ROOT}/checker.py' {program} --data '{data}' --no-wall {closed}"
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=60)
    assert done.returncode == status
    assert "Traceback" not in done.stderr


def test_only_the_beginning_of_an_endless_source_is_read() -> None:
    class Endless:
        def read(self, size: int = -1) -> bytes:
            assert size == LONGEST_SOURCE_BYTES
            return b"x" * 10

    from judge.languages.submission import read_source

    assert read_source(Endless()) == b"x" * 10
    with pytest.raises(Exception, match="found a device"):
        read_submission(Path("/dev/zero"))


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("class Main { class E {} public static void main(String[] a) {} }", ("Main", "Main")),
        ("class A { } class B { public static void main(String... a) { } }", ("Main", "B")),
        ("// class Fake\npublic class X { static void main(String[] a) { } }", ("X", "X")),
        ('class T { String s = "class U {"; static void main(String[] a) { } }', ("Main", "T")),
        ("package a.b;\npublic final class P { static void main(String[] a) {} }", ("P", "a.b.P")),
        ("record R() {} public class Q { int main; static void main(String[] a) {} }", ("Q", "Q")),
        ("public class My$A { } class B$ { static void main(String[] a) { } }", ("My$A", "B$")),
        ("@A(B.class) @C({1, 2}) public class D { static void main() { } }", ("D", "D")),
        ("class A { void main() { } static int b = f(); static void main() { } }", ("Main", "A")),
        ("class A { static int x; void main() { } } class B { }", ("Main", "Main")),
        ("class A { } } class B { static void main() { } }", ("Main", "B")),
        ("class A { /* static void main() { } */ char c = '\"'; } class B { }", ("Main", "Main")),
        ("package a.b; import c.d; class P { static void main() {} } ", ("Main", "a.b.P")),
        ("package a; class static { } class B { void main() { } }", ("Main", "a.Main")),
        ("class A { static void mains() { main(); } } class B { }", ("Main", "Main")),
        ("class A { static void Main() { } } class B { static int main() { } }", ("Main", "Main")),
        ("nothing at all", ("Main", "Main")),
        ("public class " + 300 * "x" + "{ }", ("Main", 300 * "x")),
    ],
)  # fmt: skip
def test_java_names(text: str, names: tuple[str, str]) -> None:
    assert java_names(text) == names


@pytest.mark.skipif(not shutil.which("javac"), reason="javac is not installed")
def test_java_in_a_package_with_a_byte_order_mark(data: Path, source) -> None:
    text = (
        "\ufeffpackage a.b; class Main { static class Edge {} "
        "public static void main(String[] x) throws Exception "
        "{ System.in.transferTo(System.out); } }"
    )
    done = run(
        source("m.java", text), "--data", data, "--case", "sample/01", stdout=subprocess.PIPE
    )
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("# uses std:: and using namespace\nimport sys\nprint(sys.stdin.read())\n", "Python 3"),
        ('"""Not\n#include <vector>\n"""\ndef f(x):\n    return x\n', "Python 3"),
        ("#include <unordered_map>\n#include <stdio.h>\nint main() { return 0; }\n", "C++"),
        ("#include <stdio.h>\nint main() { return 0; }\n", "C"),
        ("use std::io;\nfn main() {\n}\n", "Rust"),
        ("package main\n\nimport \"fmt\"\n\nfunc main() { fmt.Println(1) }\n", "Go"),
        ("const x = require('fs')\nfor (const y of x) console.log(y)\n", "JavaScript"),
    ],
)  # fmt: skip
def test_the_language_of_misleading_texts(text: str, name: str) -> None:
    found = guess(text)
    assert found is not None
    assert found.name == name


def test_a_byte_order_mark_is_no_part_of_the_source() -> None:
    submission = from_source(b"\xef\xbb\xbf#!/usr/bin/env node\nconsole.log(1)\n", "stdin")
    assert submission.language.name == "JavaScript"
    assert submission.source.startswith(b"#!")


@pytest.mark.parametrize(
    "unit", ["\n", " \t", "public ", "static ", "class A {", "/* ", '"\\', "'\\", "from a.a.a"]
)
def test_long_sources_are_read_in_linear_time(unit: str) -> None:
    """Quadratic time would be minutes; linear time is a tenth of a second."""
    text = "class A {" + unit * ((128 << 10) // len(unit)) + "x"
    began = time.process_time()
    java_names(text)
    guess(text)
    assert time.process_time() - began < 10
