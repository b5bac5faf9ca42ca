#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# debian.sh PACKAGE.deb [FOLDER]: installs the Debian package in a bare Debian 12 that debootstrap makes in FOLDER (a new
# one below /tmp, deleted afterwards, unless it is named), fires a shot and draws it, makes a page, a study and a metal,
# compiles an example with its headers, removes the package and looks that nothing stays. As root, with debootstrap and the
# network, from the mirror that apt-get uses; about five minutes. Exit status 1 if one of it fails.
set -euo pipefail
[ $# -ge 1 ] && [ -f "$1" ] || { sed -n 's/^# debian.sh/usage: debian.sh/p' "$0" >&2; exit 2; }
package=$(realpath "$1")
bare=${2:-$(mktemp -d /tmp/bare_debian_XXXXXX)}
is_named=$(($# >= 2))
leave() {
  ! mountpoint -q "$bare/proc" || umount "$bare/proc"
  [ "$is_named" = 1 ] || rm -rf --one-file-system "$bare"
}
trap leave EXIT
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)

if ! [ -x "$bare/usr/bin/dpkg" ]; then
  debootstrap --variant=minbase bookworm "$bare" "$mirror" >"$bare.log" 2>&1 || { tail -n 20 "$bare.log"; exit 1; }
  rm -f "$bare.log"
fi
work=$bare/root/try
rm -rf "$work"
mkdir "$work"
cp "$package" "$work/ogive.deb"
mountpoint -q "$bare/proc" || mount -t proc proc "$bare/proc" # programs find their data beside themselves

inside() { chroot "$bare" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "$@"; }
must() {
  printf '%s\n' "$*"
  inside bash -c "set -euo pipefail; cd /root/try; $*" >"$work/output.txt" 2>&1 || { tail -n 20 "$work/output.txt"; exit 1; }
}

must 'apt-get -q -y install --no-install-recommends ./ogive.deb gnuplot-nox libgl1-mesa-dri libjs-three g++'
must 'ogive --version'
must 'ogive shoot --spacing-mm 2 --out shot && grep -q perforated shot/summary.json && test -s shot/perforation.pvd'
must 'test -s shot/section.png && test -s shot/velocity.svg'
must 'ogive view shot && test -s shot/view.html'
must 'ogive sweep --vary thickness_mm=6,8 --spacing-mm 2 --out study && test "$(wc -l <study/shots.csv)" = 3'
must 'ogive materials from-tensile --yield-mpa 276 --uts-mpa 310 --young-gpa 68.9 --out metal.toml && ogive materials check metal.toml'
must 'ogive materials list | grep hardox_400'
must 'steel_blunt --help'
must 'test -s /usr/share/bash-completion/completions/ogive'
must 'g++ -std=c++20 -O2 -fopenmp -I /usr/include/eigen3 /usr/share/doc/ogive/examples/01_perforate.cpp -o example && ./example'
must 'apt-get -q -y remove ogive'
must 'left=$(find / -xdev -path /proc -prune -o -name "*ogive*" -not -path "/root/*" -not -path "/var/*" -print); test -z "$left" || { echo "left behind: $left"; exit 1; }'
printf 'the package installs, runs and goes: all in order\n'
