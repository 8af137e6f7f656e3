"""The lesson: its figures are current, its links lead somewhere, no usual mistake is missing."""

import re

from judge.diagnosis.gallery import load_gallery
from judge.diagnosis.ranking import wrong_scenes
from judge.kit.paths import ROOT, SUBMISSIONS
from pictures.cli import FIGURES
from pictures.lesson import lesson_figures

LESSON = ROOT / "docs" / "editorial.md"
NO_MISTAKES = {"always_no.py", "always_yes.py", "coin_toss.py"}  # nobody makes them in earnest


def test_the_figures_are_current():
    for name, svg in lesson_figures().items():
        assert (FIGURES / name).read_text() == svg, f"{name}: run 'make figures'"


def test_the_links_lead_somewhere():
    text = LESSON.read_text()
    links = re.findall(r"\]\(([^)#]+)\)", text)
    assert len(links) > 5
    for link in links:
        assert (LESSON.parent / link).exists(), link
    headings = {
        re.sub(r"[^\w\- ]", "", line.lstrip("# ").lower()).replace(" ", "-")
        for line in text.splitlines()
        if line.startswith("#")
    }
    assert set(re.findall(r"\]\(#([^)]+)\)", text)) <= headings


def test_every_wrong_submission_is_a_usual_mistake():
    part = LESSON.read_text().partition("## The usual")[2].partition("## How long")[0]
    named = re.findall(r"`(\w+\.(?:py|cpp))`", part)
    wrong = {path.name for path in (SUBMISSIONS / "wrong_answer").iterdir() if path.is_file()}
    assert len(named) == len(set(named))
    assert set(named) == wrong - NO_MISTAKES


def test_the_scene_of_a_mistake_is_one_that_its_program_answers_wrongly():
    gallery = load_gallery()
    names = [scene.name for scene in gallery.scenes]
    rows = re.findall(
        r"^\| .+ \| (.+) \| \[(.+)\]\(.*#gallery=(.+)\) \|$", LESSON.read_text(), re.M
    )
    assert len(rows) > 25
    for programs, shown, name in rows:
        assert shown == name
        known = [
            gallery.known[f"wrong_answer/{program}"]
            for program in re.findall(r"`(.+?)`", programs)
            if f"wrong_answer/{program}" in gallery.known
        ]
        wrong = [names.index(name) in wrong_scenes(gallery, answers) for answers in known]
        assert any(wrong) or not wrong, f"{name}: none of {programs} answers it wrongly"
