"""What students get: README, workflow, and programs to begin with."""
