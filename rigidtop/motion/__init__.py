"""Motions of rigid bodies, by numbers: NumPy and SciPy alone, never SymPy."""
