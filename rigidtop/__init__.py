"""Rigid bodies and the spinning top: derived, proved, typeset, computed."""
