"""The run: evidence found and checked for each claim, verdicts, corrections, the record."""
