#!/bin/sh
# gcc, which sees more when it optimises, says nothing of the library at -O2 and -O3 ("may be used uninitialized").
# Usage: check_optimised.sh ROOT MADE, with the folder of the headers that the build makes.
set -eu
cd "$1"
for level in -O2 -O3; do
    git ls-files 'src/*.c' | xargs -P "$(nproc)" -I{} gcc -std=c17 -Wall -Wextra -Werror -ffp-contract=off -fPIC -fvisibility=hidden \
        "$level" -Iinclude -Isrc -I"$2" -S -o /dev/null {}
done
