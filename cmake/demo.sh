#!/usr/bin/env bash
# demo.sh TOOL FOLDER: from a map and a list of suspected places to a certified policy, its test drive and its picture.
set -euo pipefail
tool=$1
folder=$2
mission=demo/missions/turtlebot3_world/mission.yaml

say() { printf '\n\033[1m%s\033[0m\n' "$*"; }
[ -t 1 ] || say() { printf '\n%s\n' "$*"; }

mkdir -p "$folder"
folder=${folder#"$PWD"/}
say "1. Learn: $mission -> $folder/demo.qtr, and the same table as C source"
"$tool" learn "$mission" -o "$folder/demo.qtr" --c "$folder/demo_policy.c"
say "2. Simulate: independent robots execute the table, sharing nothing but termination signals"
"$tool" simulate "$folder/demo.qtr"
say "3. Draw"
"$tool" draw "$folder/demo.qtr" -o "$folder/demo.svg"
printf 'The picture is %s: open it in a web browser.\n' "$folder/demo.svg"
