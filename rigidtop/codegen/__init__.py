"""The bridge, the only one, from derived expressions to functions of numbers."""
