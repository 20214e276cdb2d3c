"""A system's derivation is a page: it is written as Markdown, and read back line by line."""

from pathlib import Path

from rigidtop.cli import main
from rigidtop.starter import system as starter
from rigidtop.starter.system.spring import SYSTEM

FOLDER = Path(starter.__file__).parent


def test_the_starter_s_page_is_what_its_system_writes():
    assert (FOLDER / "spring.md").read_text("utf-8") == SYSTEM.derivation("1").markdown()


def test_what_new_writes_passes_and_falls(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "--system", "mine"]) == 0
    assert main(["check", "mine/"]) == 0
    said = capsys.readouterr().out
    assert "4 claims: 4 proved; 19 lines follow; nothing failed" in said
    page = tmp_path / "mine" / "spring.md"
    text = page.read_text("utf-8")
    for right, wrong in (
        (r"= m\dot{r}$$", r"= -m\dot{r}$$"),
        (r"m\dot{\phi}r^{2}$$", r"m\dot{\phi}r^{3}$$"),
        (r"\frac{k}{m}", r"\frac{m}{k}"),
        (r"+ \tfrac{1}{2}kr^{2}$$", r"- \tfrac{1}{2}kr^{2}$$"),
    ):
        assert text.count(right) == 1
        page.write_text(text.replace(right, wrong), "utf-8")
        assert main(["check", "mine/"]) == 1
        assert "spring.md, line" in "".join(capsys.readouterr())
