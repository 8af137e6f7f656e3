"""Pictures of scenarios: the statement's figures, and any other scene that one wants to see."""
