"""The lecture as a document: its blocks, and what writes them as LaTeX, HTML, Typst, text, MyST."""
