# The manual pages are pages, and name every command; what README, docs and manual show as a command line is one:
# manual_pages.sh GLISSON_CLI PROJECT_FOLDER
set -euo pipefail
cli=$1 pages=$2/packaging/man
failed=0
declare -A helped  # each command is asked once
help_of() {
  local key="glisson-cli $*"
  [ -n "${helped[$key]+asked}" ] || helped[$key]=$("$cli" "$@" --help)
  help=${helped[$key]}
}
help_of
for command in $(sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\).*/\1/p' <<<"$help"); do
  grep -qx "\.B $command" "$pages/glisson-cli.1" || { echo "glisson-cli.1 lacks $command."; failed=1; }
done
for command in $(sed -n '/^.SH COMMANDS/,/^.SH OPTIONS/s/^\.B \(.*\)/\1/p' "$pages/glisson-cli.1"); do
  help_of "$command" || { echo "glisson-cli.1 names $command, which does not exist."; failed=1; }
done
if command -v man >/dev/null; then
  for page in "$pages"/*.1; do
    wrong=$(LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings --local-file "$page" 2>&1 >/dev/null)
    [ -z "$wrong" ] || { echo "$page: $wrong"; failed=1; }
  done
else
  echo "man is not installed: what the pages look like was not checked."
fi

# "glisson-cli study cohort COHORT --out cohort": the command is there, and takes each option.
while read -r file line; do
  read -ra words <<<"$line"
  commands=()
  for word in "${words[@]}"; do
    help_of "${commands[@]}"
    [[ $word =~ ^[a-z][a-z-]*$ ]] && grep -q "^  $word " <<<"$help" || break
    commands+=("$word")
  done
  [ ${#commands[@]} -gt 0 ] || { echo "$file: glisson-cli $line: no such command"; failed=1; continue; }
  help_of "${commands[@]}"
  for option in $(grep -oE -- '(^| )--[a-z][A-Za-z0-9-]*' <<<"$line" || true); do
    grep -qE -- "(^|[ ,])$option( |:|$)" <<<"$help" || { echo "$file: glisson-cli ${commands[*]} has no $option"; failed=1; }
  done
done < <(cd "$2" && grep -oE 'glisson-cli [a-z][^`#]*' README.md docs/{,*/}*.md resources/manual/{,??/}*.md | sed 's/:glisson-cli / /')
exit $failed
