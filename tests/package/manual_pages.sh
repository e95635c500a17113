# The manual pages are pages, and name every command: manual_pages.sh GLISSON_CLI FOLDER
set -euo pipefail
failed=0
for command in $("$1" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\).*/\1/p'); do
  grep -qx "\.B $command" "$2/glisson-cli.1" || { echo "glisson-cli.1 lacks $command."; failed=1; }
done
for command in $(sed -n '/^.SH COMMANDS/,/^.SH OPTIONS/s/^\.B \(.*\)/\1/p' "$2/glisson-cli.1"); do
  "$1" "$command" --help >/dev/null || { echo "glisson-cli.1 names $command, which does not exist."; failed=1; }
done
if command -v man >/dev/null; then
  for page in "$2"/*.1; do
    wrong=$(LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings --local-file "$page" 2>&1 >/dev/null)
    [ -z "$wrong" ] || { echo "$page: $wrong"; failed=1; }
  done
else
  echo "man is not installed: what the pages look like was not checked."
fi
exit $failed
