"""A paper's TeX source in, a verdict for each formula out."""
