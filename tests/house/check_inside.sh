#!/bin/sh
# The library inside another project: by add_subdirectory and by FetchContent, static and shared, with the program off
# and nothing written into its own tree. The program's own source is compiled; what else would be built and how it would be
# linked is asked of ninja, since the library takes minutes. With WHOLE=1 all is built and run.
# Usage: check_inside.sh ROOT CONSUMER_DIR
set -eu
work=$PWD/inside
rm -rf "$work"
mkdir -p "$work/tree"
(cd "$1" && git ls-files -z --cached --others --exclude-standard -- CMakeLists.txt LICENSE cmake include src expat |
    xargs -0 tar -cf - ) | tar -xf - -C "$work/tree"
(cd "$work" && tar -cf batten.tar tree)
chmod -R a-w "$work/tree"
trap 'chmod -R u+w "$work/tree"' EXIT
listing() { find "$work/tree" -printf '%P %s %T@\n' | sort; }
listing > "$work/before"

count=0
for case in 'OFF OFF STATIC_LIBRARY' 'OFF ON SHARED_LIBRARY' 'ON OFF STATIC_LIBRARY' 'ON ON SHARED_LIBRARY'; do
    set -- "$1" "$2" $case
    build=$work/build$count
    cmake -G Ninja -S "$2" -B "$build" -DBY_FETCH_CONTENT="$3" -DBUILD_SHARED_LIBS="$4" -DBATTEN_TREE="$work/tree" \
        -DBATTEN_ARCHIVE="$work/batten.tar" -DCMAKE_C_FLAGS=-O0 > "$build.log" 2>&1 || { cat "$build.log"; exit 1; }
    [ "$(cat "$build/kind")" = "$5" ] || { echo "$case: batten::batten is a $(cat "$build/kind")"; exit 1; }
    other=libbatten.so
    [ "$4" = OFF ] || other=libbatten.a
    ninja -C "$build" -t commands all > "$build.plan"
    linked=libbatten.a
    [ "$4" = OFF ] || linked=libbatten.so
    grep -q -- "-o inside .*$linked" "$build.plan" || { echo "$case: $linked would not be linked"; exit 1; }
    sources=$(grep -c -- '-c .*/src/.*\.c$' "$build.plan")
    [ "$sources" = "$(find "$work/tree/src" -name '*.c' | wc -l)" ] || { echo "$case: $sources sources"; exit 1; }
    ninja -C "$build" batten_names CMakeFiles/inside.dir$(dirname "$2")/main_c.c.o > "$build.log" || { cat "$build.log"; exit 1; }
    ! grep -q "$other" "$build.plan" || { echo "$case: $other would be built as well"; exit 1; }
    count=$((count + 1))
done
if [ -n "${WHOLE:-}" ]; then
    for build in "$work/build0" "$work/build1"; do
        ninja -C "$build" inside > "$build.log" || { tail -20 "$build.log"; exit 1; }
        "$build/inside"
    done
fi
listing > "$work/after"
cmp "$work/before" "$work/after" || { echo "the library's own tree has changed"; exit 1; }
echo "$count projects configured"
