#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Proves that the README's two commands work on a fresh machine. Makes a minimal Debian 12 without
# compiler, Qt, git, sudo or display, twice; clones this repository into each, under a path with
# spaces; runs ./dev run in one and ./dev test in the other with an empty environment and closed
# stdin. Then the tests again as an ordinary user with the network cut, because a machine that is
# set up needs neither. What was seen: docs/dev/fresh-machine.md.
#
#   prove_fresh_machine.sh [--worktree] [--deps-only] FOLDER
#
# FOLDER gets the trees (about 4 GB), logs/ and out/; what an earlier run left there is removed.
# --worktree   takes the files as they are, not as committed
# --deps-only  stops after ./dev install-deps
# Needs root, git, debootstrap and a Debian mirror (MIRROR, by default the one of Debian).
set -euo pipefail

worktree=no
deps_only=no
arguments=("$@")
while [[ "${1:-}" == --* ]]; do
  case "$1" in
    --worktree) worktree=yes ;;
    --deps-only) deps_only=yes ;;
    *) echo "unknown option $1" >&2; exit 2 ;;
  esac
  shift
done
[ $# -eq 1 ] || { sed -n '3,15s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || { echo "needs root, for chroot and mount" >&2; exit 2; }

# The mounts live in a namespace of their own and vanish with the script, however it ends.
if [ "${PROOF_NAMESPACE:-}" != private ]; then
  PROOF_NAMESPACE=private exec unshare --mount --propagation private -- \
    bash "${BASH_SOURCE[0]}" "${arguments[@]}"
fi

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)"
mirror="${MIRROR:-http://deb.debian.org/debian}"
mkdir -p -- "$1"
folder="$(cd -- "$1" && pwd -P)"
logs="$folder/logs"
place="/srv/a folder with spaces" # where the clone goes, inside a tree
dev="$place/flatland/dev"
rm -rf -- "$folder"/{minimal,for-run,for-test,logs,out}
mkdir -p "$logs"

failures=0
step() { printf '\n== %s\n' "$*"; }
packages() { chroot "$1" dpkg-query -W -f='.\n' | wc -l; }

# inside LOG COMMAND...: runs it with an empty environment, shows the end of what it printed.
inside() {
  local log="$logs/$1.log" status=0 begun=$SECONDS
  shift
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp \
    "$@" >"$log" 2>&1 <&- || status=$?
  tail -n 12 "$log"
  echo "-- exit code $status after $((SECONDS - begun)) s; whole text in logs/$(basename "$log")"
  # The other steps are worth seeing all the same; the script's own exit code tells at the end.
  [ $status -eq 0 ] || failures=$((failures + 1))
}

# fresh_tree NAME: a copy of the minimal system with the checkout in it.
fresh_tree() {
  local tree="$folder/$1" tool
  cp -a "$folder/minimal" "$tree"
  mount -t proc proc "$tree/proc"
  mount --rbind /dev "$tree/dev"
  for tool in g++ cmake ninja git sudo ccache xvfb-run; do
    if chroot "$tree" sh -c "command -v $tool" >/dev/null 2>&1; then
      echo "$tool is there: this is no fresh machine" >&2
      exit 1
    fi
  done
  echo "$(packages "$tree") packages; no g++, cmake, ninja, git, sudo, ccache, xvfb-run"
  mkdir -p "$tree$place"
  if [ $worktree = yes ]; then
    mkdir "$tree$place/flatland"
    # Listed by git, so that ignored files stay out; a file deleted but still listed is left out.
    (cd "$root" && git ls-files -z --cached --others --exclude-standard |
      while IFS= read -r -d '' file; do
        if [ -e "$file" ]; then printf '%s\0' "$file"; fi
      done | tar --null -cf - -T -) | tar -C "$tree$place/flatland" -xf - --no-same-owner
    echo "the files as they are, over commit $(git -C "$root" rev-parse --short HEAD)"
  else
    git clone --quiet --no-hardlinks -- "$root" "$tree$place/flatland"
    git -C "$root" log -1 --format='commit %h, %s'
  fi
  # Data that lies beside a checkout, where there is any, lies beside the clone as well.
  if [ -d "$root/../shared" ]; then
    mkdir "$tree$place/shared"
    mount --bind "$root/../shared" "$tree$place/shared"
    mount -o remount,ro,bind "$tree$place/shared"
  fi
}

step "a minimal Debian 12 from $mirror"
debootstrap --variant=minbase bookworm "$folder/minimal" "$mirror" >"$logs/debootstrap.log" 2>&1
cp /etc/resolv.conf "$folder/minimal/etc/resolv.conf"
# The way to the mirror (a proxy, checks switched off for a snapshot) is this machine's.
apt-config dump 2>/dev/null | grep -E '^Acquire::(https?|ftp|Check-|Retries)' \
  >"$folder/minimal/etc/apt/apt.conf.d/99way" || true
fresh_tree for-test

if [ $deps_only = yes ]; then
  step "./dev install-deps"
  inside install-deps chroot "$folder/for-test" "$dev" install-deps
  step "./dev install-deps again, without a network"
  inside install-deps-again unshare --net chroot "$folder/for-test" "$dev" install-deps
  exit $failures
fi

step "./dev test"
inside test chroot "$folder/for-test" "$dev" test
echo "$(packages "$folder/for-test") packages"

step "./dev test again, as an ordinary user and without a network"
chown -R 1000:1000 "$folder/for-test$place/flatland"
inside test-again unshare --net chroot --userspec=1000:1000 "$folder/for-test" "$dev" test

step "./dev run, without a display, in another fresh tree"
fresh_tree for-run
inside run chroot "$folder/for-run" "$dev" run
cp -r "$folder/for-run$place/flatland/out" "$folder/out" || failures=$((failures + 1))
echo "$(packages "$folder/for-run") packages"

step "./dev run features preset:thesis, as an ordinary user and without a network"
chown -R 1000:1000 "$folder/for-run$place/flatland"
inside run-features unshare --net chroot --userspec=1000:1000 "$folder/for-run" \
  "$dev" run features preset:thesis --format csv

step "$failures steps failed; pictures in out/"
(cd "$folder" && ls -l out) || true
[ $failures -eq 0 ]
