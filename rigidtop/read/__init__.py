"""LaTeX of mechanics becomes equations: of notes, of answers, of files."""
