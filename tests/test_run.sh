#!/usr/bin/env bash
# test_run.sh RUN BUILD: the functions of `run`, sourced; BUILD is a build tree with the demo. Works in the current folder.
set -euo pipefail
here=$PWD
run=$1 tree=$2
. "$run"

faults=0
# expect WHAT FOUND WANTED
expect() {
  [ "$2" != "$3" ] || return 0
  printf '%s: found "%s", wanted "%s"\n' "$1" "$2" "$3"
  faults=$((faults + 1))
}

# The library is named first in a list that fills any pipe: who stops reading there leaves the writer to die.
test_a_library_that_is_there_is_found_every_time() {
  local missing=0 _
  { printf '\tlibglib-2.0.so.0 (libc6,x86-64) => /lib/libglib-2.0.so.0\n' && printf '\tlib%s.so\n' {1..5000}; } >libraries
  ldconfig() { cat libraries; }
  for _ in {1..300}; do has_library libglib-2.0.so.0 || missing=$((missing + 1)); done
  has_library libglib-3.0.so.0 && missing=absent
  unset -f ldconfig
  expect "times of 300 that a library was missed" "$missing" 0
}

# Under a compiler that compiles nothing, all headers are missing.
test_a_command_asks_for_what_it_needs_and_no_more() {
  local found CC=false root=$here/empty
  mkdir -p "$root/cmake" "$root/tools/bridge" && touch "$root"/{cmake,tools/bridge}/requirements{,-demo,-charts,-export,-field,-format,-mcap}.txt
  have() { return 1; }
  have_pip() { return 1; }
  has_library() { return 1; }
  has_rsvg() { return 1; }
  packages() { command=$1 && parts_of "$1" && missing_packages | paste -sd ' '; }
  local host="cmake gcc libc6-dev libyaml-dev ninja-build"
  expect "packages of quarter" "$(packages quarter)" "$host"
  expect "packages of bench" "$(packages bench)" "$host"
  expect "packages of bench --field" "$(parts=(field) && missing_packages | paste -sd ' ')" "$host python3 python3-pip"
  expect "packages of paper" "$(packages paper)" "$host python3 python3-pip"
  found="cmake gcc libc6-dev libcivetweb-dev libglib2.0-0 libyaml-dev ninja-build python3 python3-pip"
  expect "packages of demo" "$(packages demo)" "$found"
  expect "packages of games" "$(packages games)" "$found"
  expect "packages of losses" "$(packages losses)" "$found"
  expect "packages of test" "$(packages test)" "$found"
  expect "tools of demo" "$(command=demo && parts_of demo && missing_tools | paste -sd ' ')" "libspng-dev libstb-dev libproj-dev librsvg2-dev libsodium-dev"
  expect "tools of quarter" "$(command=quarter && parts_of quarter && missing_tools | paste -sd ' ')" "libspng-dev libstb-dev libproj-dev librsvg2-dev"
  parts_of test
  has_picolibc() { return 1; }
  board_kinds=arm
  expect "packages of firmware" "$(packages firmware)" "cmake gcc gcc-arm-none-eabi libc6-dev libyaml-dev ninja-build picolibc-arm-none-eabi qemu-system-arm"
  board_kinds=""
  has_browser_package() { return 1; }
  expect "tools of test where there is no browser to be had" "$(command=test missing_tools | sort -u | paste -sd ' ')" \
    "iproute2 libproj-dev librsvg2-dev libsodium-dev libspng-dev libstb-dev mandoc nftables scdoc spin"
  apt-cache() { return 0; }
  with_firmware=yes
  found=$(command=test missing_tools | tr ' ' '\n' | sort -u | paste -sd ' ')
  expect "tools of test --firmware" "$found" "avr-libc clang cppcheck g++ gcc-arm-none-eabi gcc-avr gcc-i686-linux-gnu \
gcc-powerpc-linux-gnu gcc-riscv64-unknown-elf iproute2 libc6-dev-i386-cross libc6-dev-powerpc-cross libproj-dev librsvg2-dev libsodium-dev \
libspng-dev libstb-dev mandoc nftables picolibc-arm-none-eabi picolibc-riscv64-unknown-elf qemu-system-arm qemu-system-misc qemu-user scdoc simavr spin"
  with_firmware=""
  has_browser_package() { return 0; }
  expect "tools of test" "$(command=test missing_tools | sort -u | paste -sd ' ')" \
    "chromium chromium-driver iproute2 libproj-dev librsvg2-dev libsodium-dev libspng-dev libstb-dev mandoc nftables scdoc spin"
}

# "Install it and build again", faults of the tool say.
test_a_library_that_was_missing_is_looked_for_once_it_is_there() {
  local build=$here/cache library
  mkdir -p "$build"
  compiles() { [ "$1" = "$there" ]; }
  has_rsvg() { [ rsvg = "$there" ]; }
  for library in SPNG PROJ RSVG; do
    printf '%s_LIBRARY:FILEPATH=%s_LIBRARY-NOTFOUND\n' $library $library >"$build/CMakeCache.txt"
    there=nothing
    has_come_since && expect "$library, still missing" found missing
    case $library in RSVG) there=rsvg ;; *) there=${library,,}.h ;; esac
    has_come_since || expect "$library" missing found
    printf '%s_LIBRARY:FILEPATH=/usr/lib/lib.so\n' $library >"$build/CMakeCache.txt"
    has_come_since && expect "$library, known of" found known
  done
  return 0
}

test_without_root_one_line_to_paste_names_all() {
  local missing=(cmake libyaml-dev) tools=(spin) said
  find_root() { return 1; }
  said=$(install_missing 2>&1) && expect "without root" "gone on" "given up"
  expect "lines to paste" "$(grep -c 'apt-get install' <<<"$said")" 1
  expect "the line" "$(grep 'apt-get install' <<<"$said")" \
    "As root: apt-get update && apt-get install -y --no-install-recommends cmake libyaml-dev spin"
}

# The set-up of a test goes on without its tools, but not without what it is built with.
test_tools_that_cannot_be_installed_do_not_stop_a_test() {
  local missing=() tools=(spin)
  find_root() { return 0; }
  install_packages() { return 1; }
  install_missing 2>said.txt || expect "a tool" missing "gone on without"
  expect "said of a tool" "$(cat said.txt)" "Going on: what needs them is skipped."
  missing=(cmake)
  install_missing 2>said.txt && expect "a package" "gone on without" refused
  return 0
}

test_what_is_followed_is_logged_and_keeps_its_status() {
  local log=$here/follow.log status=0
  : >"$log"
  follow bash -c 'printf "one\ntwo\n"; echo three >&2; exit 7' 2>said.txt || status=$?
  expect "status" "$status" 7
  expect "log" "$(sort "$log" | paste -sd ' ')" "one three two"
}

test_what_was_skipped_is_shown_with_its_reason() {
  local build=$here/log
  mkdir -p "$build/Testing/Temporary"
  printf '%s\n' '1/2 Testing: viewer' '1/2 Test: viewer' 'Command: "x"' 'SKIPPED: no browser' '2/2 Test: tool' \
    't.c:7:test_a:IGNORE: not as root' 'fine' >"$build/Testing/Temporary/LastTest.log"
  expect "skipped" "$(skipped_tests)" "  viewer: no browser
  tool: not as root"
}

test_long_tests_run_when_they_are_asked_for_or_named() {
  local with_firmware words
  words_of() { with_firmware="" && read_test_words "$@" && printf '%s\n' "${with_firmware:-without}:${words[*]}"; }
  expect "words of test" "$(words_of)" 'without:-LE ^long$'
  expect "words of test -j 1" "$(words_of -j 1)" 'without:-j 1 -LE ^long$'
  expect "words of test --long" "$(words_of --long)" 'without:'
  expect "words of test --firmware --long" "$(words_of --firmware --long)" 'yes:'
  expect "words of test --long --firmware joint -V" "$(words_of --long --firmware joint -V)" 'yes:-R joint -V'
  expect "words of test --verbose" "$(words_of --verbose)" 'without:--verbose -LE ^long$'
  expect "words of test --max-width=80" "$(words_of --max-width=80)" 'without:--max-width=80 -LE ^long$'
  expect "words of test model" "$(words_of model)" 'without:-R model'
}

test_words_that_a_command_does_not_know_are_refused_with_one_line() {
  local words status said
  for words in "bundle" "bundle one two" "bundle file" "firmware nothing" "firmware --help" "firmware cortex-m3 cortex-m4f" \
    "sizes --help" "test --lng" "nothing"; do
    : >file
    status=0
    # shellcheck disable=SC2086
    (build() { echo built; }; main $words) >out.txt 2>said.txt || status=$?
    expect "status of $words" "$status" 2
    expect "printed by $words" "$(cat out.txt)" ""
    said=$(grep -E '^(run|bundle): ' said.txt || true)
    expect "lines said by $words" "$(grep -c "${words%% *}" <<<"$said")" 1
  done
  (main test --help) >out.txt
  expect "help of test" "$(sed -n '1s/ \[.*//p' out.txt)" "./run demo"
}

test_the_demo_takes_paths_from_the_users_folder() {
  local build=$tree status=0
  build() { :; }
  mkdir -p "user's folder"
  cp "$(dirname "$run")/demo/missions/minefield/map.txt" "user's folder/own map.txt"
  (cd "user's folder" && main demo "own map.txt" --robots 2 --seed 1 -o "own page.html" --save-table "own.qtr") >said.txt 2>&1 || status=$?
  [ "$status" = 0 ] || cat said.txt
  expect "status of the demo" "$status" 0
  expect "what was written" "$(ls "user's folder")" "own map.txt
own page.html
own.qtr"
  expect "told of it" "$(sed -n 's/^wrote \([^:]*\).*/\1/p' said.txt)" "own page.html
own.qtr"
}

test_a_checkout_under_an_odd_path_has_a_plain_name_always_the_same() {
  local odd="$here/Müller's \"robot\" \$HOME (v2)" name
  mkdir -p "$odd"
  expect "a plain path" "$(plain_name /usr/lib)" /usr/lib
  name=$(plain_name "$odd")
  expect "odd letters in the name" "${name//[a-zA-Z0-9\/._+-]/}" ""
  expect "where the name leads" "$(cd "$name" && pwd -P)" "$(cd "$odd" && pwd -P)"
  expect "the name again" "$(plain_name "$odd")" "$name"
  ln -sfn /usr "$name"
  expect "the name of a link that led astray" "$(readlink "$(plain_name "$odd")")" "$odd"
  rm "$name" && rmdir "${name%/*}"
}

test_a_name_that_another_could_have_made_is_refused() {
  local odd="$here/a b" name
  mkdir -p "$odd"
  name=$(plain_name "$odd")
  rm "$name" && rmdir "${name%/*}"
  ln -s "$here" "${name%/*}"
  plain_name "$odd" >said.txt 2>&1 && expect "a link in the place of the folder" taken refused
  rm "${name%/*}"
  return 0
}

for name in $(compgen -A function test_); do
  rm -rf "${here:?}"/*
  (faults=0 && "$name" && [ "$faults" = 0 ]) || { printf 'FAIL %s\n' "$name" && faults=$((faults + 1)); }
done
[ "$faults" = 0 ] && printf 'all hold\n'
