#!/usr/bin/python3
"""What `explain` makes of measured silicone (Dawood and others 2026; silicone_phantom_compression of the shared data):
measured_silicone.py GLISSON_CLI. Silicone stiffens in compression and softens once it was stretched, so that no one
effect explains it to the noise, and what is named predicts tests that were left out far better than the declared model.
Exit code 77 where the data is absent."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve()
MAKER = HERE.parents[1] / "support" / "measured" / "silicone.py"
SHARED = pathlib.Path(os.environ.get("GLISSON_SHARED_DATA", HERE.parents[2].parent / "shared" / "data"))


def main():
    data = SHARED / "silicone_phantom_compression"
    if not data.is_dir():
        print(f"skipped: no real data at {data}")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "silicone"
        subprocess.run([sys.executable, MAKER, made, "--data", data], check=True)
        ask = lambda *words: json.loads(subprocess.run(
            [sys.argv[1], *words, "--json", "--quiet"], check=True, capture_output=True, text=True).stdout)
        found = ask("explain", str(made / "experiment.json"), "--out", folder + "/report")
        declared = ask("predict", str(made / "heldout.json"))["rms"]
        better = ask("predict", str(made / "heldout.json"), "--with", folder + "/report/model.json")["rms"]
    print(f"silicone: {found['verdict']}, {found['effects'][0]['kind']}; tests left out: declared {declared:.2f}, "
          f"better model {better:.2f} kPa")
    assert found["verdict"] == "unexplained", found["verdict"]
    assert found["effects"][0]["kind"] == "strain-stiffening", found["effects"]
    assert better < 0.2 * declared


if __name__ == "__main__":
    main()
