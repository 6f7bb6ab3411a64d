"""Where methods fail, one experiment a module, each with the exact answer beside it."""
