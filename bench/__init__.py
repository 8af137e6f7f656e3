"""Measurements, apart from the tests: no test fails because a machine is slow."""
