"""Measures what the time limit rests on."""
