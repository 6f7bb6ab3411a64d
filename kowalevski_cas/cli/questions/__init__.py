"""The questions of the command ``find``, a module each.

A module has a docstring, ``add_arguments(parser)``, and ``search(on, scene, arguments)``, which
yields one :class:`~kowalevski_cas.verify.found.Finding` after the other; what was found before the
time is over is kept.
"""
