"""The equations of the lecture as its pages print them, read when a claim asks for one."""

from rigidtop.read.page import Displays

printed = Displays(__package__)
