"""What every command stands on: files read and written as a whole, tables, progress on stderr."""
