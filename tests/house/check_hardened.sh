#!/bin/sh
# Builds a copy of the tree with Debian's hardening flags and similar ones: no warnings, and the module for the browser
# equals, byte for byte, the one built without them in another folder. Usage: check_hardened.sh ROOT
set -eu
root=$1
copy=$PWD/elsewhere
build=$copy/build/hardened
rm -rf "$copy"
mkdir -p "$copy"
(cd "$root" && git ls-files -z -c -o --exclude-standard | tar -c --null -T - --ignore-failed-read 2> "$copy.left_out") |
    tar -x -C "$copy"

CFLAGS="$(dpkg-buildflags --get CFLAGS) $(dpkg-buildflags --get CPPFLAGS) -fstack-clash-protection -fcf-protection -g0"
LDFLAGS="$(dpkg-buildflags --get LDFLAGS) -Wl,-z,now"
export CFLAGS LDFLAGS
cmake -G Ninja -S "$copy" -B "$build" --log-level=WARNING -DCMAKE_BUILD_TYPE=None -DBATTEN_WERROR=ON > "$copy.log" &&
    cmake --build "$build" >> "$copy.log" 2>&1 || { tail -40 "$copy.log"; exit 1; }
grep -q stack-protector-strong "$build/build.ninja" || { echo "The flags did not arrive"; exit 1; }
"$build/batten" info "$copy/examples/car.svg" > "$copy.info"
for part in batten.wasm batten-later.wasm; do
    cmp "$root/build/wasm/$part" "$copy/build/wasm/$part"
done
