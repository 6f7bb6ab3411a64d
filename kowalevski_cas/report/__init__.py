"""Reports of a run: one document, as HTML, LaTeX and PDF.

Here is the document; each writer is a module, and ``pdf`` makes files of them.
"""
