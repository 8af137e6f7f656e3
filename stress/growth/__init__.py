"""How a program's time grows with one quantity of its input, measured on ladders of inputs."""
