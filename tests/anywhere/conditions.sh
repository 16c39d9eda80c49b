#!/usr/bin/env bash
# conditions.sh [CONDITION[+CONDITION...]...]: the whole suite under each of these; all of them, one after the other, by default:
#   date       400 days from now (package faketime)
#   zone       the time of the Chatham Islands, 45 minutes off everybody's
#   turkish    LC_ALL=tr_TR.UTF-8, whose i is no i (package locales)
#   german     LC_ALL=de_DE.UTF-8, with a decimal comma
#   umask      077
#   core       one core
#   load       two busy loops beside
#   elsewhere  a clone of the last commit under a path with blanks, quotes, $, parentheses and umlauts, started from another
#              folder; as root also as another user, who has no sudo
# Conditions joined by + hold at once. Everything is built before, so that nothing is downloaded on another date.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
run=$here/../../run
work=$(mktemp -d)
busy=()
clean_up() {
  [ "${#busy[@]}" = 0 ] || kill "${busy[@]}" 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT

# locale NAME: made for this run alone.
locale_of() {
  mkdir -p "$work/locale"
  [ -d "$work/locale/$1.UTF-8" ] || localedef -i "$1" -f UTF-8 "$work/locale/$1.UTF-8"
  with+=(env "LOCPATH=$work/locale" "LC_ALL=$1.UTF-8")
}

clone_elsewhere() {
  local place="$work/Müller's \"robot\" \$HOME (v2) äöü"
  git clone -q "$(git -C "$here" rev-parse --show-toplevel)" "$place"
  cp -r "$here/../../.cache" "$place/"
  run=$place/run
  cd /
  if [ "$(id -u)" = 0 ]; then
    chmod 755 "$work"
    chown -R nobody "$place"
    with+=(setpriv --reuid=nobody --regid=nogroup --clear-groups env "HOME=$place")
  fi
}

# Sets up one condition: in the environment, or as words before the command.
arrange() {
  case $1 in
    date) with+=(faketime '+400 days') && export FAKETIME_DONT_FAKE_MONOTONIC=1 NO_FAKE_STAT=1 ;;
    zone) export TZ=Pacific/Chatham ;;
    turkish) locale_of tr_TR ;;
    german) locale_of de_DE ;;
    umask) umask 077 ;;
    core) with+=(taskset -c 0) ;;
    load)
      for _ in 1 2; do
        timeout 3600 bash -c 'while true; do :; done' &
        busy+=($!)
      done
      ;;
    elsewhere) clone_elsewhere ;;
    *) echo "conditions.sh: there is no condition '$1'" >&2 && return 2 ;;
  esac
}

# In a subshell: what is arranged ends with it.
try_under() (
  with=()
  trap '[ "${#busy[@]}" = 0 ] || kill "${busy[@]}"' EXIT
  printf '==== %s\n' "$1"
  for condition in ${1//+/ }; do arrange "$condition" || exit; done
  "${with[@]}" "$run" test
)

[ $# -gt 0 ] || set -- date zone turkish german umask core load elsewhere
"$run" test -N >/dev/null
failed=()
for conditions in "$@"; do
  try_under "$conditions" || failed+=("$conditions")
done
[ "${#failed[@]}" = 0 ] || { printf 'Failed under: %s\n' "${failed[*]}" && exit 1; }
