# What bash offers: completion.sh GLISSON_CLI COMPLETION_FILE
set -uo pipefail
PATH=$(dirname "$1"):$PATH
compopt() { :; }  # is for a line that is being typed
source "$2"

failed=0
# offers "typed so far" "expected among the answers"
offers() {
  read -ra COMP_WORDS <<<"$1"
  [[ $1 == *" " ]] && COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _glisson_cli
  if ! printf '%s\n' "${COMPREPLY[@]}" | grep -qxF -- "$2"; then
    echo "'$1' should offer $2, and offers: ${COMPREPLY[*]}"
    failed=1
  fi
}
offers "glisson-cli se" segment
offers "glisson-cli study " cohort
offers "glisson-cli study cohort --o" --out
offers "glisson-cli segment case.glisson --str" --structure
offers "glisson-cli sirgn sequence.json --method g" gnra
offers "glisson-cli invert case.glisson --method " lfe
exit $failed
