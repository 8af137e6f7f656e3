"""The gallery's scenes: where they come from, how they are chosen, how well they diagnose."""
