"""The run: verdicts with their evidence, the record, and what lets others check it."""
