#!/usr/bin/env bash
# Times the way of a new user: clone, `./run demo`, certified policy. What is not installed is downloaded on the way.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
begin=$(date +%s%N)
git clone -q "$1" "$folder/quarter"
"$folder/quarter/run" demo >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
end=$(date +%s%N)
grep -qi certified "$folder/log"
printf 'clone to certified policy on the demo mission: %d.%01d s (target: under 180 s)\n' \
  $(((end - begin) / 1000000000)) $(((end - begin) / 100000000 % 10))
