"""The live page: the derived equations running in a browser."""
