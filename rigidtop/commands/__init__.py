"""Commands of the shell, one a module: `add_options` to a parser, `run` what was parsed."""
