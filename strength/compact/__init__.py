"""The small selection of cases, `data/compact.json`: how it is chosen, and what it costs."""
