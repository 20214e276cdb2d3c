"""What a figure drew, read back from it."""

import numpy as np
import pytest
from matplotlib.figure import Figure as Canvas


@pytest.fixture
def axes():
    return Canvas().subplots()


def line(axes, label):
    [found] = [each for each in axes.lines if each.get_label() == label]
    return np.asarray(found.get_xydata(), dtype=float)


def direction(vector):
    return np.asarray(vector) / np.linalg.norm(vector)
