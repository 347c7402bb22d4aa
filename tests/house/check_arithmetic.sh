#!/bin/sh
# Where double is not IEEE double, the library does not compile and an error says why; on 32-bit x86 it is compiled with
# SSE2. Usage: check_arithmetic.sh SRC_DIR
set -u
src=$1
fail=0

# tried WHAT COMPILER...: must be refused with the message WHAT, or accepted if WHAT is "".
tried() {
    what=$1
    shift
    said=$(printf '#include "base/real.h"\nint batten_used;\n' | "$@" -std=c17 "-I$src" -fsyntax-only -x c - 2>&1)
    case $said in
        "") [ -z "$what" ] || { echo "$*: not refused"; fail=1; } ;;
        *"error: "*"$what"*) [ -n "$what" ] || { echo "$*: $said"; fail=1; } ;;
        *) echo "$*: $said"; fail=1 ;;
    esac
}

tried "" gcc
tried "" clang
tried "-msse2 -mfpmath=sse" gcc -m32
tried "-msse2 -mfpmath=sse" gcc -mfpmath=387
tried "-msse2 -mfpmath=sse" clang -m32 -mno-sse2
tried "" gcc -m32 -msse2 -mfpmath=sse
tried "" clang -m32 -msse2
tried "-ffast-math" gcc -ffast-math
tried "-ffast-math" clang -ffast-math

narrow="gcc -m32 -msse2 -mfpmath=sse -std=c17 -fsyntax-only -I$src -I$src/../include"
if echo '#include <math.h>' | $narrow -x c - 2> /dev/null; then
    for file in "$src"/base/*.c "$src"/curve/*.c; do $narrow -Wall -Wextra -Wconversion -Werror "$file" || fail=1; done
else
    echo "No 32-bit C library here (gcc-multilib): only the check of arithmetic itself was compiled"
fi
exit $fail
