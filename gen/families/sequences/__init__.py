"""Attacks what is carried from one scenario of a file to the next."""
