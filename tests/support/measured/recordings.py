"""What the scripts of this folder share: where the recordings lie, and what is asked on the command line."""

import argparse
import os
import pathlib
import sys

SHARED = pathlib.Path(os.environ.get("GLISSON_SHARED_DATA",
                                     pathlib.Path(__file__).resolve().parents[3].parent / "shared" / "data"))


def asked_for(description, folder, more=lambda ask: None):
    """OUT, made where it is absent, and --data DIR, which must be there; `more` adds arguments of one script's own."""
    ask = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("out", type=pathlib.Path)
    ask.add_argument("--data", type=pathlib.Path, default=SHARED / folder)
    more(ask)
    asked = ask.parse_args()
    if not asked.data.is_dir():
        sys.exit(f"no recordings at {asked.data}")
    asked.out.mkdir(parents=True, exist_ok=True)
    return asked
