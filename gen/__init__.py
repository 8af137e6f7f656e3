"""Makes the test data: shapes, families, the plan, the input validator and the build."""
