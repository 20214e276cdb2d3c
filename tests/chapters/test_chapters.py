"""The chapters that come with rigidtop: every line follows, and a wrong one is told."""

from __future__ import annotations

import json

import pytest

from rigidtop.cli import main
from rigidtop.collection.chapters import CHAPTERS, chapters

SLIPS = {
    "asymmetric": (
        ("euler", r"= \omega_1\gamma_3 - \omega_3", r"= \omega_1\gamma_3 + \omega_3"),
        (
            "euler",
            r"\mathbf N = MgR\gamma_3\mathbf e_2 - MgR",
            r"\mathbf N = MgR\gamma_3\mathbf e_2 + MgR",
        ),
        ("stays", r"\dot\Lambda = 2\mathbf L", r"\dot\Lambda = \mathbf L"),
        ("stays", r"\omega_1 = \text{const}", r"\omega_2 = \text{const}"),
        ("kovalevskaya", r"-\frac{2(\kappa - 1)}", r"\frac{2(\kappa - 1)}"),
        ("kovalevskaya", r"\dot\xi_2 = -\omega_3\xi_1 \tag", r"\dot\xi_2 = \omega_3\xi_1 \tag"),
        ("kovalevskaya", r"\frac{4(\kappa - 2)}{\kappa^2}", r"\frac{2(\kappa - 2)}{\kappa^2}"),
        ("swings", r"-\frac{MgR}{\lambda_3}\sin", r"-\frac{MgR}{\lambda_3}\cos"),
        ("swings", r"E = MgR \tag", r"E = 2MgR \tag"),
        ("swings", r"\ddot\gamma_1 = \dot", r"\ddot\gamma_1 = -\dot"),  # no claim needs it
        ("swings", r"\approx -\nu_2^2", r"\approx -\nu_3^2"),
        ("neighbours", r"e^{\sigma t} \tag", r"e^{-\sigma t} \tag"),
        ("neighbours", r"\ln10 \tag", r"\ln2 \tag"),
    ),
    "coupled": (
        ("pendulums", r"V \approx -2mgl + \tfrac12mgl", r"V \approx -2mgl - \tfrac12mgl"),
        (
            "pendulums",
            r"\ddot\theta_2 \approx -mgl\theta_2 + D",
            r"\ddot\theta_2 \approx -mgl\theta_2 - D",
        ),
        ("modes", r"\right)^2 - D^2 = 0", r"\right)^2 + D^2 = 0"),
        ("modes", r"\kappa = \frac gl + \frac{2D}m", r"\kappa = \frac gl + \frac Dm"),
        ("modes", r"a_2 = -a_1", r"a_2 = a_1"),
        ("modes", r"\eta = \tfrac12\theta_0\cos\omega_2t", r"\eta = \tfrac12\theta_0\sin\omega_2t"),
        ("modes", r"= \theta_0\cos\frac{(\omega_2 - ", r"= \theta_0\sin\frac{(\omega_2 - "),
        ("many", r"(\kappa_1 - \kappa_2)\mathbf w", r"(\kappa_1 + \kappa_2)\mathbf w"),
        ("many", r"\frac{4D}m\sin^2", r"\frac{4D}m\cos^2"),
    ),
    "foucault": (
        (
            "laboratory",
            r"\mathbf a + 2\boldsymbol\omega\times\mathbf v",
            r"\mathbf a + \boldsymbol\omega\times\mathbf v",
        ),
        ("laboratory", r"\mathbf e_3\cdot\mathbf S - g", r"\mathbf e_3\cdot\mathbf S + g"),
        ("stone", r"- 4\omega^2x \tag", r"+ 4\omega^2x \tag"),
        ("stone", r"\tfrac13\omega gt^3", r"\tfrac16\omega gt^3"),
        ("pendulum", r"- 2\Omega\dot x \tag", r"+ 2\Omega\dot x \tag"),
        ("pendulum", r"X = A\cos\omega_1t", r"X = A\cos\omega_0t"),
        ("pendulum", r"y = -A\cos\omega_1t", r"y = A\cos\omega_1t"),
    ),
    "freebody": (
        (
            "euler",
            r"\dot\omega_2 = (\lambda_3 - \lambda_1)",
            r"\dot\omega_2 = (\lambda_1 - \lambda_3)",
        ),
        ("euler", r"\lambda_2)a_3^2 - \lambda_1", r"\lambda_2)a_3^2 + \lambda_1"),
        ("axes", r"\omega_2^2 - \frac{", r"\omega_2^2 + \frac{"),
        ("axes", r"\approx -\nu^2\omega_2", r"\approx \nu^2\omega_2"),
        ("axes", r"\dot\omega_3 \approx 0", r"\dot\omega_3 \approx \omega_1"),  # no claim needs it
        ("jacobi", r"= -pmsc \tag", r"= -pm^2sc \tag"),
        ("jacobi", r"\frac{4K(m)}p", r"\frac{2K(m)}p"),
        ("flip", r"\tanh pt", r"\tanh^2pt"),
        ("flip", r"(1 + y^2)(1 + k'^2y^2)", r"(1 + y^2)(1 - k'^2y^2)"),
        ("flip", r"\ln\frac4{k'}", r"\ln\frac2{k'}"),
        ("phase", r"\frac{2E}L + \dot\beta\cos", r"\frac EL + \dot\beta\cos"),
        ("phase", r"- \Omega + 2\pi", r"+ \Omega + 2\pi"),
    ),
    "gyrocompass": (
        ("wheel", r"-\dot\psi\sin\alpha\,", r"\dot\psi\sin\alpha\,"),
        (
            "wheel",
            r"\dot\psi + \Omega\cos\beta\cos\alpha \tag",
            r"\dot\psi + \Omega\cos\alpha \tag",
        ),
        (
            "north",
            r"\cos\alpha - C\omega\Omega\cos\beta\sin\alpha \tag",
            r"\cos\alpha - C\omega\Omega\sin\beta\sin\alpha \tag",
        ),
        ("north", r"(C\omega - A\Omega\cos\beta)", r"(C\omega + A\Omega\cos\beta)"),
        ("swing", r"\sqrt{\frac A{C", r"\sqrt{\frac C{A"),
        ("swing", r"\approx \nu^2\varepsilon", r"\approx -\nu^2\varepsilon"),
        ("swing", r"(\cos\alpha - \cos\alpha_0)", r"(\cos\alpha_0 - \cos\alpha)"),
        ("damping", r"\dot E = -2\gamma", r"\dot E = -\gamma"),
        ("damping", r"\frac\gamma{\nu_1}", r"\frac\gamma\nu"),
        ("damping", r"(1 + \nu t)", r"(1 - \nu t)"),
        ("damping", r"\vartheta - \Omega\sin\beta, ", r"\vartheta + \Omega\sin\beta, "),
        ("ship", r"\frac vR\sin\alpha \tag", r"\frac vR\cos\alpha \tag"),
        ("ship", r"\tan\delta = \frac v{R\Omega\cos", r"\tan\delta = \frac v{R\Omega\sin"),
    ),
    "kepler": (
        ("orbit", r"= mr\dot\phi^2 - \frac k{r^2}", r"= mr\dot\phi^2 + \frac k{r^2}"),
        ("orbit", r"= -\frac{\dot r}{r^2\dot\phi}", r"= \frac{\dot r}{r^2\dot\phi}"),
        ("orbit", r"+ u = \frac{mk}{\ell^2} \tag", r"- u = \frac{mk}{\ell^2} \tag"),
        ("orbit", r"\right)\cos\phi \tag", r"\right)\cos2\phi \tag"),
        ("time", r"\eta - \varepsilon\sin\eta = nt", r"\eta - \varepsilon\cos\eta = nt"),
        ("time", r"= -\frac k{2a}", r"= -\frac k{a}"),
        (
            "vector",
            r"- \frac{\dot r}{r^2}\mathbf r\right)",
            r"+ \frac{\dot r}{r^2}\mathbf r\right)",
        ),
        ("vector", r"\frac2m\left(E + \frac kr", r"\frac2m\left(E - \frac kr"),
        ("vector", r"+ 2mEL^2", r"- 2mEL^2"),
    ),
    "rolling": (
        ("wheel", r"I\ddot\chi = -\mu R", r"I\ddot\chi = \mu R"),
        ("wheel", r"\ddot\chi = \frac{mRg", r"\ddot\chi = \frac{mg"),
        ("wheel", r"\tan\alpha < \mu_s", r"\tan\alpha > \mu_s"),
        ("turntable", r"\tfrac72\dot", r"\tfrac75\dot"),
        (
            "turntable",
            r"\mathbf v + \mathbf n\times(\mathbf",
            r"\mathbf v - \mathbf n\times(\mathbf",
        ),
        ("turntable", r"\frac{49}{4\Omega^2}", r"\frac7{2\Omega^2}"),
    ),
    "tippe": (
        ("jellett", r"\mathbf n - f\mathbf q", r"\mathbf n + f\mathbf q"),
        ("jellett", r"\dot J = -\dot{\mathbf q}", r"\dot J = \dot{\mathbf q}"),
        ("energy", r"\dot E = -f\,\mathbf v", r"\dot E = f\,\mathbf v"),
        ("ends", r"\Omega_2 = \frac{h_1}{h_2}", r"\Omega_2 = \frac{h_2}{h_1}"),
        ("over", r"\tfrac12\lambda_3(\mathbf e", r"\tfrac12\lambda_1(\mathbf e"),
        ("over", r"(\lambda_3h_2 - \lambda_1r)$$", r"(\lambda_3h_2 + \lambda_1r)$$"),
        ("over", r"\frac{Mgh_2^4}{\lambda_3rh_1^2}", r"\frac{Mgh_2^4}{\lambda_3rh_1^4}"),
    ),
}
"""Lines of each chapter, by their pages, with what a pen may make of them."""


def checked(folder, capsys):
    """The lines of a folder, as `check --lines` tells them, and the exit code."""
    code = main(["check", f"{folder}/", "--lines", "--json"])
    return json.loads(capsys.readouterr().out), code


@pytest.fixture(params=chapters())
def copy(request, tmp_path):
    """A chapter as `rigidtop new --from` copies it, with its name."""
    folder = tmp_path / request.param
    assert main(["new", "--from", request.param, str(folder)]) == 0
    return folder


def test_each_chapter_checks_without_a_gap(copy, capsys):
    assert main(["check", f"{copy}/"]) == 0, capsys.readouterr().out


def test_wrong_lines_are_told_with_what_the_move_gives(copy, capsys):
    wanted = []
    for page, right, wrong in SLIPS[copy.name]:
        file = copy / f"{page}.md"
        text = file.read_text("utf-8")
        assert text.count(right) >= 1, right
        wanted.append((file.name, text.count("\n", 0, text.index(right)) + 1))
        file.write_text(text.replace(right, wrong, 1), "utf-8")
    capsys.readouterr()
    lines, code = checked(copy, capsys)
    assert code == 1
    told = {(line["file"], line["line"]): line for line in lines}
    for file, line in wanted:
        judged = told[file, line]
        assert judged["verdict"] == "gap", (file, line)
        assert judged["note"], (file, line)


def test_every_chapter_has_its_slips():
    assert {*chapters()} == {*SLIPS}
    assert all(len(slips) >= 5 for slips in SLIPS.values())


def test_chapters_are_listed(capsys):
    assert main(["list", "--chapters", "--json"]) == 0
    listed = json.loads(capsys.readouterr().out)
    assert [each["name"] for each in listed] == sorted(p.name for p in CHAPTERS.iterdir())
    assert main(["list", "--chapters", "3.57"]) == 2


def test_a_chapter_that_is_not_there_is_told(tmp_path, capsys):
    assert main(["new", "--from", "keplr", str(tmp_path / "mine")]) == 2
    assert "no chapter 'keplr'; there are" in capsys.readouterr().err
