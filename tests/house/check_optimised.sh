#!/bin/sh
# What only a compiler that sees all sources at once can find, such as a number that may be read before it is set: gcc at -O3, and at
# -O2 when it links, has no warning for the amalgamation. Usage: check_optimised.sh ROOT
set -eu
work=$PWD/optimised
rm -rf "$work"
mkdir -p "$work"
python3 "$1/cmake/amalgamate.py" "$1" "$work"
cd "$work"
warned() { gcc -std=c17 -Wall -Wextra -Wno-misleading-indentation -Werror "$@" batten.c; } # about indentation: as check_amalgamation.sh
warned -O3 -c -o whole.o
warned -O2 -flto=auto -fPIC -shared -o whole.so
rm whole.o whole.so
