"""Run the command, as a part of a package or where the folder has been copied to."""

import sys
from importlib import import_module
from types import ModuleType

if not __package__:  # the folder is run: it is a package, whatever else has its name
    sys.modules["checker"] = ModuleType("checker")
    sys.modules["checker"].__path__ = [sys.path.pop(0)]

if __name__ == "__main__":
    sys.exit(import_module(".command", __package__ or "checker").main(sys.argv[1:]))
