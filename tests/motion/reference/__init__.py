"""A 40-digit reference for motions: the judge of closed forms and of integrators."""
