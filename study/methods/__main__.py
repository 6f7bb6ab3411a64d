"""The process in which SymPy is asked what people ask it: ``python -m study.methods``."""

from study.methods.typed import decide
from study.process import serve

if __name__ == "__main__":
    serve(decide)
