"""Formulas as they are written: immutable trees of nodes, and how they are printed.

A node says what stands on the paper and not what it means: `2x/2` stays as it is.  What it means is
worked out by `rigidtop.judge.meaning`.  Nodes are equal where they are written alike; they can be
hashed, copied and pickled.
"""
