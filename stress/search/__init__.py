"""The search for a smallest input that one program gets wrong: draw, find, shrink."""
