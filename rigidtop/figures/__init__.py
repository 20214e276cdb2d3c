"""Figures: drawn from computed motions, on any Axes, readable in grey.

A module a theme, each with functions that draw on a given Axes and with the finished drawings;
`catalog` lists these.  Nothing here touches the state of pyplot.

>>> from matplotlib.figure import Figure
>>> from rigidtop import HeavyTop
>>> from rigidtop.figures.potential import draw_effective_potential
>>> top = HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
>>> axes = Figure().subplots()
>>> draw_effective_potential(axes, top.motion(theta=1.0, omega3=40.0))
>>> axes.get_xlabel()
'$\\\\theta$  (degrees)'

`drawing.rendered` gives the bytes of a finished one, with numbers of one's own:

>>> from rigidtop.figures.catalog import named
>>> from rigidtop.figures.drawing import rendered
>>> rendered(named("torque"), "pdf", {"theta": 0.5})[:5]
b'%PDF-'
"""
