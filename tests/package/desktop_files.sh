# The desktop's files are what the desktop takes: desktop_files.sh FOLDER
set -euo pipefail
failed=0 checked=0
if command -v appstreamcli >/dev/null; then
  checked=1
  appstreamcli validate --no-net "$1/io.glisson.Glisson.metainfo.xml" || failed=1
fi
if command -v desktop-file-validate >/dev/null; then
  checked=1
  desktop-file-validate "$1/io.glisson.Glisson.desktop" || failed=1
fi
if command -v update-mime-database >/dev/null; then
  checked=1
  place=$(mktemp -d)
  trap 'rm -rf "$place"' EXIT
  mkdir -p "$place/packages"
  cp "$1/io.glisson.Glisson.xml" "$place/packages"
  update-mime-database "$place"
  grep -q 'application/x-glisson-case' "$place/types" || { echo "The type of a case was not taken in."; failed=1; }
fi
if [ $checked = 0 ]; then
  echo "Skipped: none of appstreamcli, desktop-file-validate, update-mime-database is installed."
  exit 77
fi
exit $failed
