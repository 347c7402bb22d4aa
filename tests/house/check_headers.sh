#!/bin/sh
# Each public header compiles alone, in C17 and in C++17, without a warning. Usage: check_headers.sh INCLUDE_DIR
set -eu
fail=0
count=0
for header in "$1"/batten/*.h; do
    name=batten/$(basename "$header")
    for compiler in 'gcc -std=c17 -x c' 'g++ -std=c++17 -x c++' 'clang -std=c17 -x c' 'clang++ -std=c++17 -x c++'; do
        count=$((count + 1))
        # Included twice, to test the guard.
        printf '#include <%s>\n#include <%s>\nint batten_used;\n' "$name" "$name" |
            $compiler -Wall -Wextra -Wpedantic -Werror -fsyntax-only "-I$1" - ||
            { echo "$name does not stand alone: $compiler"; fail=1; }
    done
done
echo "$count compilations"
[ "$count" -gt 0 ] && exit $fail
