"""Servers for programs in which papers are written: editors, and agents."""
