"""What a judging looks like: on the terminal, as JSON, as JUnit XML."""
