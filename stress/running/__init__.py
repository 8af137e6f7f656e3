"""Running one program on files of scenarios, and knowing which of its answers are wrong."""
