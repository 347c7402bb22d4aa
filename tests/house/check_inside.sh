#!/bin/sh
# The library inside another project: by add_subdirectory and by FetchContent, static and shared, with the program off
# and nothing written into its own tree. One of them is built whole and run; what the others would build is asked of ninja.
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
    ninja -C "$build" -n -v > "$build.plan"
    grep -q 'libbatten' "$build.plan" || { echo "$case: nothing would be built"; exit 1; }
    ! grep -q "$other" "$build.plan" || { echo "$case: $other would be built as well"; exit 1; }
    count=$((count + 1))
done
listing > "$work/after"
cmp "$work/before" "$work/after" || { echo "the library's own tree has changed"; exit 1; }
ninja -C "$work/build1" inside > "$work/build.log" || { tail -20 "$work/build.log"; exit 1; }
"$work/build1/inside"
listing > "$work/after"
cmp "$work/before" "$work/after" || { echo "the library's own tree has changed"; exit 1; }
echo "$count projects configured, one of them built"
