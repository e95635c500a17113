# The wheel holds a package that answers from where it was unpacked: wheel.sh BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail
[ -d "$1/python/glisson" ] || { echo "Skipped: the package for Python was not built (pybind11-dev, python3-dev)."; exit 77; }
/usr/bin/python3 -c 'import numpy' 2>/dev/null || { echo "Skipped: numpy is not there."; exit 77; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
wheel=$("$2/packaging/wheel" --build "$1" --out "$place")
/usr/bin/python3 -m zipfile -e "$wheel" "$place/unpacked"
cd "$place"
PYTHONPATH="$place/unpacked" /usr/bin/python3 - "$place/unpacked" <<'PYTHON'
import pathlib, sys
import glisson
assert pathlib.Path(glisson.__file__).is_relative_to(sys.argv[1]), glisson.__file__
assert glisson.Volume.empty((2, 3, 4)).array.shape == (2, 3, 4)
assert glisson.plan_hardware(liver_volume_cm3=1500, accuracy_mm=5)["platforms"]
(record,) = pathlib.Path(sys.argv[1]).glob("glisson-*.dist-info/RECORD")
for line in record.read_text().split():
    assert (record.parent.parent / line.split(",")[0]).is_file(), line
print("The wheel answers as", glisson.__version__)
PYTHON
