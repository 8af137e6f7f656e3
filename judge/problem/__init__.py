"""The problem as the judge knows it: declaration, verdicts, test cases, manifest."""
