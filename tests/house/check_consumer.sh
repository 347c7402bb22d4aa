#!/bin/sh
# A third-party project can use the installed library: found both ways, linked both ways, from C and C++, and run;
# also after the installed tree was moved. The C++ wrapper is compiled by g++ and by clang++. Usage: check_consumer.sh BUILD_DIR CONSUMER_DIR
set -eu
work=$PWD/consumer
rm -rf "$work"
mkdir -p "$work"
cmake --install "$1" --prefix "$work/first" > "$work/install.log"
mv "$work/first" "$work/moved"
tree=$work/moved
pc=$(find "$tree" -name batten.pc)
lib=$(dirname "$(find "$tree" -name libbatten.so)")
export PKG_CONFIG_PATH="$(dirname "$pc")" PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1 PKG_CONFIG_ALLOW_SYSTEM_LIBS=1

count=0
for way in find_package pkg_config; do
    by=OFF
    compiler=g++
    [ $way = pkg_config ] && by=ON && compiler=clang++
    cmake -G Ninja -S "$2" -B "$work/$way" -DBY_PKG_CONFIG=$by -DCMAKE_CXX_COMPILER=$compiler -DCMAKE_PREFIX_PATH="$tree" > "$work/$way.log" 2>&1 &&
        cmake --build "$work/$way" >> "$work/$way.log" 2>&1 || { cat "$work/$way.log"; exit 1; }
    for program in static_c shared_c static_cpp shared_cpp static_svg shared_svg wrapper; do
        LD_LIBRARY_PATH=$lib "$work/$way/$program"
        needs=$(readelf -d "$work/$way/$program" | grep -c 'NEEDED.*libbatten.so.0.2' || true)
        case $program in
            static_* | wrapper) [ "$needs" = 0 ] || { echo "$way/$program is not static"; exit 1; } ;;
            shared_*) [ "$needs" = 1 ] || { echo "$way/$program is not shared"; exit 1; } ;;
        esac
        count=$((count + 1))
    done
done
echo "$count consumers ran"
