"""For tests whose experiments CalculiX makes: importing this ends them with exit code 77 where it or numpy is missing.
UNDECLARED are the makers."""

import pathlib
import sys

UNDECLARED = pathlib.Path(__file__).parents[1] / "support" / "undeclared"
sys.path.insert(0, str(UNDECLARED))
try:
    import calculix
except ModuleNotFoundError as missing:
    print(f"skipped: {missing.name} is not installed")
    sys.exit(77)
if not calculix.available():
    print("skipped: CalculiX (ccx) is not installed")
    sys.exit(77)
