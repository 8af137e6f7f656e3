"""Measures the margins of the time limit."""
