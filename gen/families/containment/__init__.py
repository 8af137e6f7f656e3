"""Attacks tests for intersection that miss containment: edges that cross, or vertices inside."""
