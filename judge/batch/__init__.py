"""A whole class: a directory or a zip of hand-ins, judged one row each."""
