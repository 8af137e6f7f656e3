"""Packages for other judges, all made from this one source. One module per judge, in targets/."""
