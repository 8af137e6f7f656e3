"""Attacks programs that answer from less than the whole question."""
