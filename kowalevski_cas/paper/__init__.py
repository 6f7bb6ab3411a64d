"""Papers as their authors printed them: displays, scenes, claims; elaborated into statements."""
