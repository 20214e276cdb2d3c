"""The top on a table: friction and air, and in closed form where there is neither."""
