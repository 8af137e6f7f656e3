"""Shrinking: ever smaller scenarios, or sequences of them, that still fail."""
