"""The picture of which claim rests on which: a layered drawing, made from a run.

The layout is computed once, in millimetres, and drawn twice: as TikZ inside the LaTeX report,
and as SVG, which Typst and browsers read. Nothing in it depends on fonts that are measured or
on the order of a set, so that it is the same from run to run.
"""

from kowalevski_cas.report.graph.drawing import Drawing, picture
from kowalevski_cas.report.graph.layout import WIDTH
