"""The commands of `python -m gen`, each in a module of its own."""
