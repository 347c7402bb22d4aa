#!/bin/sh
# Two builds of the libraries and the program with debug information, in differently named folders, are identical byte
# for byte. The second is that of check_hardened.sh. Usage: check_reproducible.sh ROOT
set -eu
root=$1
there=$PWD/elsewhere/build/hardened
here=$PWD/reproducible
rm -rf "$here"
. "$root/tests/house/hardening.sh"
cmake -G Ninja -S "$root" -B "$here" --log-level=WARNING -DCMAKE_BUILD_TYPE=None -DBATTEN_WERROR=ON -DBATTEN_WASM_CLANG=OFF > "$here.log" &&
    CCACHE_DISABLE=1 cmake --build "$here" --target batten batten_shared batten_program >> "$here.log" 2>&1 ||
    { tail -40 "$here.log"; exit 1; }
for file in libbatten.a "$(basename "$here"/libbatten.so.*.*.*)" batten; do
    cmp "$here/$file" "$there/$file"
    ! grep -q "$root" "$here/$file" || { echo "$file tells where it was built"; exit 1; }
done
