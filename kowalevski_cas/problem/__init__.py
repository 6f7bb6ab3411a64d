"""Statements as plain data: spaces, goals, evidence; their meaning, their JSON, their checker."""
