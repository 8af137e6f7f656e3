"""Solvers held against each other, on random scenarios and on complete small worlds."""
