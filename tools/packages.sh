# Sourced by ./run and ./test: installs missing Debian packages.

say() { printf '\033[1m== %s\033[0m\n' "$*"; }

# need PACKAGE PROBE: the package is needed unless the probe exists (a command, or a path, which may have
# wildcards).
missing=
need() {
    case $2 in
        /*) for path in $2; do [ -e "$path" ] && return 0; done ;;
        *) command -v "$2" > /dev/null && return 0 ;;
    esac
    missing="$missing $1"
}

install_missing() {
    [ -n "$missing" ] || { say "Debian packages: all there"; return 0; }
    say "Debian packages to install:$missing"
    command -v apt-get > /dev/null || { echo "This is not Debian. Install by hand what matches:$missing" >&2; exit 1; }
    as_root=
    if [ "$(id -u)" != 0 ]; then
        command -v sudo > /dev/null || { echo "Install as root: apt-get install$missing" >&2; exit 1; }
        as_root=sudo
    fi
    $as_root apt-get update -q
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
    missing=
}

need_to_build() {
    need gcc cc
    need libc6-dev /usr/include/stdio.h
    need cmake cmake
    need ninja-build ninja
    need pkg-config pkg-config
    need libexpat1-dev /usr/include/expat.h
    need libcairo2-dev /usr/include/cairo/cairo.h
    need zlib1g-dev /usr/include/zlib.h
    need libmicrohttpd-dev /usr/include/microhttpd.h
    need clang-16 clang-16
    need lld-16 wasm-ld-16
    need wasi-libc /usr/include/wasm32-wasi/wasi/api.h
    need libclang-rt-16-dev-wasm32 '/usr/lib/llvm-16/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a'
    need binaryen wasm-opt
    need esbuild esbuild
    # The type face of the page; without it, words stand in the system's.
    need fonts-inter-variable '/usr/share/fonts/truetype/inter-vf/Inter*'
    need python3-fonttools /usr/lib/python3/dist-packages/fontTools
    need python3-brotli '/usr/lib/python3/dist-packages/brotli*'
}

# For the target site.
need_to_publish() {
    need python3 python3
    need python3-pil /usr/lib/python3/dist-packages/PIL
    need npm npm
    need pandoc pandoc
}

need_to_test() {
    need_to_build
    need_to_publish
    need g++ g++
    need clang clang
    need llvm llvm-cov
    need libcmocka-dev /usr/include/cmocka.h
    need libclang-rt-14-dev '/usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.asan*.a'
    need clang-format clang-format
    need clang-tidy clang-tidy
    need git git
    need ccache ccache
    need curl curl
    need jq jq
    need python3-scipy '/usr/lib/python3/dist-packages/scipy'
    need python3-shapely '/usr/lib/python3/dist-packages/shapely'
    need fontforge-nox fontforge
    need python3-ezdxf '/usr/lib/python3/dist-packages/ezdxf'
    need python3-pip /usr/lib/python3/dist-packages/pip
    need mypy mypy
    need python3-jsonschema /usr/lib/python3/dist-packages/jsonschema
    need librsvg2-bin rsvg-convert
    need poppler-utils pdftocairo
    need ghostscript gs
    need admesh admesh
    need assimp-utils assimp
    need blender blender
    need occt-draw occt-draw
    need zsh zsh
    need fish fish
    need groff-base groff
    need nodejs node
    need chromium chromium
    need chromium-headless-shell chromium-headless-shell
    need firefox-esr firefox-esr
    need webkit2gtk-driver WebKitWebDriver
    need xvfb Xvfb
    need xauth xauth
    need dpkg-dev dpkg-buildflags
    need adwaita-icon-theme /usr/share/icons/Adwaita/scalable
    need tango-icon-theme /usr/share/icons/Tango/scalable
    need fonts-nanum /usr/share/fonts/truetype/nanum
}

# build PRESET: configures and builds build/PRESET.
build() {
    say "Building build/$1"
    cmake --preset "$1" --log-level=WARNING && cmake --build --preset "$1" ${2:+--target "$2"}
}
