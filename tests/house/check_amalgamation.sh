#!/bin/sh
# The amalgamation compiles alone, in C17 without extensions, with gcc and clang, and computes what the library does, bit
# for bit (tests/wasm/parity.c). Usage: check_amalgamation.sh ROOT PARITY
# Not asked about indentation: gcc takes three times as long for it in so large a file.
set -eu
work=$PWD/amalgamation
rm -rf "$work"
mkdir -p "$work/include/batten"
python3 "$1/cmake/amalgamate.py" "$1" "$work"
"$2" > "$work/library.txt"

# The header alone is enough for a program, and says the same things twice without harm.
sed 's|<batten/batten.h>|"batten.h"|' "$1/tests/consumer/main_c.c" > "$work/main.c"
for compiler in gcc clang; do
    (cd "$work" && $compiler -std=c17 -pedantic -Wall -Wextra -Wno-misleading-indentation -Werror -O0 -c batten.c -o $compiler.o)
    $compiler -std=c17 -pedantic -Werror "$work/main.c" "$work/$compiler.o" -o "$work/$compiler.main" -lm
    "$work/$compiler.main"
    $compiler -std=c17 -I"$1/src" -I"$work/made" -I"$1/include" -I"$1/tests" "$1/tests/wasm/parity.c" "$1/tests/wasm/parity_native.c" \
        "$work/$compiler.o" -o "$work/$compiler.parity" -lm
    "$work/$compiler.parity" > "$work/$compiler.txt"
    # What it shows to a linker are names that begin with bat_.
    foreign=$(nm -g --defined-only "$work/$compiler.o" | awk '$3 !~ /^bat_/ { print $3 }')
    [ -z "$foreign" ] || { echo "$compiler: names without bat_: $foreign"; exit 1; }
done
python3 "$1/tests/wasm/same_bits.py" "$work/library.txt" "$work/gcc.txt" "$work/clang.txt"
