# Somebody else's program, built on the core as it is installed: installed_core.sh BUILD_FOLDER CONSUMER_FOLDER
set -euo pipefail
build=$1 consumer=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

cmake --install "$build" --prefix "$place/prefix" --component development >/dev/null
! find "$place/prefix" -name '*_internal.h' | grep . || { echo "A room's own headers were installed."; exit 1; }
cmake -S "$consumer" -B "$place/build" -G Ninja -DCMAKE_PREFIX_PATH="$place/prefix" -DCMAKE_BUILD_TYPE=Release >"$place/log" 2>&1 ||
  { cat "$place/log"; exit 1; }
cmake --build "$place/build"
said=$("$place/build/weigh")
echo "$said"
[ "$said" = "A cube of 20 mm: 8.0 ml, 2 kPa in shear is 5.98 kPa in tension." ]
