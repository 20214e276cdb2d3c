"""Both motions of the lecture in closed form; no code is shared with the equations they judge."""
