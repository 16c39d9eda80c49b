#!/usr/bin/env bash
# roots.sh FOLDER SUITE...: a fresh bookworm, trixie or noble by debootstrap in FOLDER/SUITE, and in a clone of this checkout
# there `./run demo` and `./run test`: nothing may fail, or be silent for more than 10 s. As root; a root that is there already
# is taken as it is. CERTIFICATES may name a file of further certificates that the root is to trust.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
checkout=$(git -C "$here" rev-parse --show-toplevel)
[ $# -ge 2 ] || { sed -n '2,4s/^# //p' "$0" >&2 && exit 2; }
folder=$1
shift

make_root() {
  local suite=$1 root=$2 options=() from=()
  if [ "$suite" = noble ]; then
    options=(--components=main,universe ${UBUNTU_KEYRING:+--keyring="$UBUNTU_KEYRING"})
    [ -e /usr/share/debootstrap/scripts/noble ] ||
      from=("${UBUNTU_MIRROR:?debootstrap does not know noble here: name a mirror of Ubuntu}" gutsy)
  fi
  debootstrap --variant=minbase --include=git,ca-certificates "${options[@]}" "$suite" "$root" "${from[@]}"
  umount "$root/proc" "$root/sys" 2>/dev/null || true
}

# What is mounted in a namespace of its own is gone with it: nobody removes a root with /proc in it.
within() {
  unshare -m bash -euc 'mount --make-rprivate / && mount -t proc proc "$0/proc" && mount -t sysfs sys "$0/sys" &&
    mount -t tmpfs -o mode=1777 shm "$0/dev/shm" && exec chroot "$0" "$@"' "$@"
}

try_root() {
  local suite=$1 root=$folder/$1
  [ -e "$root/etc/os-release" ] || make_root "$suite" "$root"
  cp /etc/resolv.conf "$root/etc/"
  printf '127.0.0.1 localhost\n::1 localhost\n' >"$root/etc/hosts"  # as every machine has it
  mkdir -p "$root/dev/shm"
  if [ -n "${CERTIFICATES:-}" ]; then
    cp "$CERTIFICATES" "$root/usr/local/share/ca-certificates/own.crt"
    within "$root" update-ca-certificates >/dev/null
  fi
  rm -rf "$root/srv/quarter"
  git clone -q "$checkout" "$root/srv/quarter"
  for command in demo test; do
    python3 -B "$here/silence.py" 10 env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/srv LANG=C.UTF-8 \
      bash -c "$(declare -f within)"'; within "$@"' - "$root" /srv/quarter/run "$command"
  done
}

for suite in "$@"; do
  printf '==== %s\n' "$suite"
  try_root "$suite"
done
