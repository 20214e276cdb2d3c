"""Figures that move."""

import io
import subprocess

import numpy as np
import pytest
from matplotlib.animation import FFMpegWriter
from PIL import Image

from rigidtop.errors import RigidtopError
from rigidtop.figures import animation
from rigidtop.figures.animation import animated
from rigidtop.figures.catalog import FIGURES, named

MOVING = [drawing.name for drawing in FIGURES if drawing.animate]


@pytest.mark.parametrize("name", MOVING)
def test_gif_has_its_frames_and_they_differ(name):
    calls = []
    made = animated(
        named(name), "gif", frames=5, progress=lambda done, total: calls.append((done, total))
    )
    assert calls == [(k, 5) for k in range(1, 6)]
    film = Image.open(io.BytesIO(made))
    assert film.n_frames == 5
    assert film.info["duration"] == 1000 / animation.PER_SECOND
    frames = []
    for k in range(5):
        film.seek(k)
        frames.append(np.asarray(film.convert("L"), dtype=float))
    for k in range(5):
        for other in range(k):
            assert np.abs(frames[k] - frames[other]).max() > 100
    assert {frame.shape for frame in frames} == {frames[0].shape}


def test_a_turn_of_the_cones_ends_where_it_began():
    film = named("rolling-cones").animate(**named("rolling-cones").values())
    tips = []
    for share in (0.0, 0.25, 1.0):
        film.show(share)
        tips.append([text.xy for each in film.canvas.axes for text in each.texts])
    assert np.array(tips[0]) == pytest.approx(np.array(tips[2]), abs=1e-9)
    assert np.abs(np.array(tips[0]) - np.array(tips[1])).max() > 0.3


def test_what_does_not_move():
    with pytest.raises(RigidtopError, match="figure 'cones' does not move"):
        animated(named("cones"), "gif")


def test_without_ffmpeg(monkeypatch):
    monkeypatch.setattr(FFMpegWriter, "isAvailable", classmethod(lambda cls: False))
    with pytest.raises(RigidtopError, match="an mp4 wants ffmpeg, which is not found") as refusal:
        animated(named("top"), "mp4", frames=2)
    assert "\n" not in str(refusal.value)


def test_ffmpeg_that_fails_is_one_line(monkeypatch):
    class Broken(animation.PillowWriter):
        def finish(self):
            raise subprocess.CalledProcessError(1, ["ffmpeg"])

    monkeypatch.setattr(animation, "writer", lambda kind: Broken(fps=20))
    with pytest.raises(RigidtopError, match=r"the mp4 cannot be written: .*ffmpeg") as refusal:
        animated(named("top"), "mp4", frames=2)
    assert "\n" not in str(refusal.value)


@pytest.mark.skipif(not FFMpegWriter.isAvailable(), reason="needs ffmpeg")
def test_mp4():
    made = animated(named("top"), "mp4", frames=4)
    assert made[4:8] == b"ftyp"
