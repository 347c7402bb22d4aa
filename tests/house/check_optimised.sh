#!/bin/sh
# What only a compiler that sees all sources at once can find, such as a number that may be read before it is set: gcc at -O3 has no
# warning for the amalgamation. Usage: check_optimised.sh ROOT
set -eu
work=$PWD/optimised
rm -rf "$work"
mkdir -p "$work"
python3 "$1/cmake/amalgamate.py" "$1" "$work"
cd "$work"
gcc -O3 -std=c17 -Wall -Wextra -Wno-misleading-indentation -Werror -c batten.c -o whole.o # about indentation: as check_amalgamation.sh
rm whole.o
