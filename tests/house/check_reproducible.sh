#!/bin/sh
# What is built with debug information does not depend on the folder: of the objects of the libraries and the program one in six
# is made once more in another folder than that of check_hardened.sh, and is the same byte for byte; linked once more, the
# libraries and the program are; and none of them tells where it was built. Usage: check_reproducible.sh ROOT
set -eu
root=$1
there=$PWD/elsewhere/build/hardened
here=$PWD/reproducible
made="batten batten_shared batten_program"
rm -rf "$here"
. "$root/tests/house/hardening.sh"
cmake -G Ninja -S "$root" -B "$here" --log-level=WARNING -DCMAKE_BUILD_TYPE=None -DBATTEN_WERROR=ON -DBATTEN_WASM_CLANG=OFF > "$here.log" ||
    { tail -40 "$here.log"; exit 1; }
objects=$(ninja -C "$here" -t inputs $made | grep '\.o$' | sort -u | awk 'NR % 6 == 1')
CCACHE_DISABLE=1 ninja -C "$here" $objects >> "$here.log" 2>&1 || { tail -40 "$here.log"; exit 1; }
for object in $objects; do
    cmp "$here/$object" "$there/$object"
done
for file in libbatten.a "$(basename "$there"/libbatten.so.*.*.*)" batten; do
    ! grep -q "$root" "$there/$file" || { echo "$file tells where it was built"; exit 1; }
    mv "$there/$file" "$here/"
done
ninja -C "$there" $made >> "$here.log" 2>&1 || { tail -40 "$here.log"; exit 1; }
for file in libbatten.a "$(basename "$there"/libbatten.so.*.*.*)" batten; do
    cmp "$here/$file" "$there/$file"
done
echo "$(echo "$objects" | wc -l) objects are the same"
