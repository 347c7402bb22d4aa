#!/bin/sh
# Builds a copy of the tree with Debian's hardening flags and similar ones: no warnings. The module for the browser would be made
# there by the same commands as without them, and what they make is the same, byte for byte, in another folder: of its objects one
# in six is made. Usage: check_hardened.sh ROOT
set -eu
root=$1
copy=$PWD/elsewhere
build=$copy/build/hardened
rm -rf "$copy"
mkdir -p "$copy"
(cd "$root" && git ls-files -z -c -o --exclude-standard | tar -c --null -T - --ignore-failed-read 2> "$copy.left_out") |
    tar -x -C "$copy"

. "$root/tests/house/hardening.sh"
# The program without the module, which is not built whole once more.
cmake -G Ninja -S "$copy" -B "$build" --log-level=WARNING -DCMAKE_BUILD_TYPE=None -DBATTEN_WERROR=ON -DBATTEN_WASM_CLANG=OFF > "$copy.log" &&
    CCACHE_DISABLE=1 cmake --build "$build" --target batten batten_shared batten_program >> "$copy.log" 2>&1 && # for check_reproducible.sh
    cmake --build "$build" >> "$copy.log" 2>&1 || { tail -40 "$copy.log"; exit 1; }
grep -q stack-protector-strong "$build/build.ninja" || { echo "The flags did not arrive"; exit 1; }
"$build/batten" info "$copy/examples/car.svg" > "$copy.info"

werror=$(grep '^BATTEN_WERROR:' "$root/build/wasm/CMakeCache.txt")
(cd "$copy" && cmake --preset wasm --log-level=WARNING "-D$werror") > "$copy.log" || { tail -40 "$copy.log"; exit 1; }
commands() { ninja -C "$1/build/wasm" -t commands batten.wasm | grep -v 'ccache.*--version' | sed "s|$1|.|g"; }
commands "$root" > "$copy.here"
commands "$copy" > "$copy.there"
cmp "$copy.here" "$copy.there" || { echo "The module is made by other commands"; diff "$copy.here" "$copy.there" | head -4; exit 1; }
objects=$(ninja -C "$copy/build/wasm" -t inputs batten.wasm | grep '\.obj$' | awk 'NR % 6 == 1')
CCACHE_DISABLE=1 ninja -C "$copy/build/wasm" $objects >> "$copy.log" 2>&1 || { tail -40 "$copy.log"; exit 1; }
for object in $objects; do
    cmp "$root/build/wasm/$object" "$copy/build/wasm/$object"
done
echo "$(echo "$objects" | wc -l) objects are the same"
