"""Figures: drawn from computed motions, on any Axes, readable in grey.

A module a theme, each with functions that draw on a given Axes and with the finished drawings;
`catalog` lists these.  Nothing here touches the state of pyplot.
"""
