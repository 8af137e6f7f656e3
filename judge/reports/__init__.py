"""The reports of a judging: on the terminal, as JSON, as JUnit XML."""
