"""What several judges' packages have in common: YAML, the input validator, where cases go."""
