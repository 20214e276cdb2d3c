"""An equation, a sentence or a table becomes layout, then LaTeX, MathML or text on a line."""
