"""A paper's text: its files, styles, displays, macros and sentences; no mathematics."""
