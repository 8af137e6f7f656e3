"""Runs one program within limits, behind a wall, and reports facts."""
