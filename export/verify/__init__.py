"""Proofs that a package works: one module per judge, each with `verify(package, scratch)`."""
