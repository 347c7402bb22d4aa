#!/bin/sh
# Two builds of the libraries and the program with debug information, in differently named folders, are identical byte
# for byte. The second folder is the copy made by check_hardened.sh, which compares the module's objects.
# Usage: check_reproducible.sh ROOT
set -eu
root=$1
copy=$PWD/elsewhere
unset CFLAGS LDFLAGS
work=$PWD/reproducible
rm -rf "$work"
mkdir -p "$work"

# built SOURCE BUILD
built() {
    cmake -G Ninja -S "$1" -B "$2" --log-level=WARNING -DCMAKE_BUILD_TYPE=None -DBATTEN_WASM_CLANG=OFF -DCMAKE_C_FLAGS="-g" > "$2.log" &&
        CCACHE_DISABLE=1 cmake --build "$2" --target batten batten_shared batten_program >> "$2.log" 2>&1 ||
        { tail -40 "$2.log"; exit 1; }
}
built "$root" "$work/one"
built "$copy" "$work/the_other"
for file in libbatten.a "$(basename "$work"/one/libbatten.so.*.*.*)" batten; do
    cmp "$work/one/$file" "$work/the_other/$file"
    ! grep -q "$root" "$work/one/$file" || { echo "$file tells where it was built"; exit 1; }
done
