"""One judge for every line: a statement holds in all worlds in which what stands above it holds.

A world is a set of numbers for all letters and their rates at which everything said so far is true.
`text.judged` takes a whole text; `context.Context` is what is known at a line of it.
"""
