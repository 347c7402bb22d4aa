#!/bin/sh
# Both libraries export only symbols that begin with bat_; the shared one exports exactly those that the public headers
# declare with BAT_API. Usage: check_symbols.sh LIBRARY_DIR INCLUDE_DIR
set -eu
static=$1/libbatten.a
shared=$1/libbatten.so
fail=0

foreign=$(nm -g --defined-only "$static" | awk 'NF == 3 && $3 !~ /^bat_/ { print $3 }')
[ -z "$foreign" ] || { echo "libbatten.a: global symbols without bat_:"; echo "$foreign"; fail=1; }

shown=$(nm -D --defined-only "$shared" | awk '{ print $3 }' | sort)
[ -n "$shown" ] || { echo "libbatten.so: no symbols at all"; fail=1; }
foreign=$(echo "$shown" | grep -v '^bat_' || true)
[ -z "$foreign" ] || { echo "libbatten.so: symbols without bat_:"; echo "$foreign"; fail=1; }

# No mutable globals. Data written only by the loader (.data.rel.ro) counts as constant.
mutable=$(nm --defined-only "$static" | awk 'NF == 3 && $2 ~ /^[bBcCdD]$/ { print $3 }' | while read -r name; do
    objdump -t "$static" | awk -v name="$name" '$NF == name && !/\*UND\*/ && $0 !~ /\.(data\.rel\.)?ro/ { print name }'
done | sort -u)
[ -z "$mutable" ] || { echo "libbatten.a: mutable globals:"; echo "$mutable"; fail=1; }

# libbatten-svg: exports what svg_read.h declares, and nothing else of its own.
apart=$(nm -D --defined-only "$1/libbatten-svg.so" | awk '{ print $3 }')
[ "$apart" = bat_svg_read ] || { echo "libbatten-svg.so shows: $apart"; fail=1; }

declared=$(find "$2/batten" -name '*.h' ! -name svg_read.h -exec cat {} + | tr '\n' ' ' | sed 's/BAT_API/\n&/g' | sed -n 's/^BAT_API[^(;]*[ *]\(bat_[a-z0-9_]*\)(.*/\1/p' | sort -u)
echo "$declared" > "$1/declared.txt"
echo "$shown" > "$1/shown.txt"
hidden=$(comm -13 "$1/declared.txt" "$1/shown.txt")
[ -z "$hidden" ] || { echo "libbatten.so: shown but declared by no public header:"; echo "$hidden"; fail=1; }
missing=$(comm -23 "$1/declared.txt" "$1/shown.txt")
[ -z "$missing" ] || { echo "declared with BAT_API but not in libbatten.so:"; echo "$missing"; fail=1; }

soname=$(readelf -d "$shared" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
[ "$soname" = libbatten.so.0.2 ] || { echo "SONAME is '$soname', expected libbatten.so.0.2"; fail=1; }
for library in libbatten.so libbatten-svg.so; do
    needs=$(readelf -d "$1/$library" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | sed 's/\.so.*//' | sort | tr '\n' ' ')
    case "$library: $needs" in
        "libbatten.so: libc libm " | "libbatten-svg.so: libbatten libc libexpat ") ;;
        *) echo "$library needs $needs"; fail=1 ;;
    esac
done
echo "$(echo "$shown" | wc -l) symbols shown, $(echo "$declared" | wc -l) declared"
exit $fail
