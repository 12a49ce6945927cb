#!/bin/sh
# Crevice in one command: sets up what is missing, builds, runs.
#   ./crevice.sh demo              run every chapter; ends with the path of one index page
#   ./crevice.sh test              build and run every test
#   ./crevice.sh web               the lab as one page for a browser; ends with its path
#   ./crevice.sh ANYTHING ELSE     passed on to the program, such as: ./crevice.sh render columns --out out
# --no-install as the first argument leaves the packages alone.
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
start=$PWD
program="$here/build/release/crevice"

say() { printf '%s\n' "crevice.sh: $*" >&2; }

missing_packages() {
    sed '/^# continuous integration/,$d; /^#/d; /^$/d' "$here/packages.apt" | while read -r package; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || printf '%s ' "$package"
    done
}

install_packages() {
    command -v dpkg-query >/dev/null 2>&1 || { say "this is no Debian: install the packages of packages.apt by hand"; return; }
    missing=$(missing_packages)
    [ -n "$missing" ] || return 0
    say "packages to install: $missing"
    if [ "$(id -u)" -eq 0 ]; then as_root=; else as_root=${SUDO-sudo}; fi
    $as_root apt-get update -qq
    # shellcheck disable=SC2086  # one word a package
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >&2
}

# build CONFIGURE_PRESET [BUILD_PRESET]
build() {
    cd "$here"
    cmake --preset "$1" >/dev/null
    cmake --build --preset "${2-$1}" >&2
    cd "$start"
}

# The word after --out or --out= among the arguments, else "out".
out_of() {
    out=out previous=
    for word in "$@"; do
        [ "$previous" != --out ] || out=$word
        case $word in --out=*) out=${word#--out=} ;; esac
        previous=$word
    done
    printf '%s\n' "$out"
}

# Too large for packages.apt: only who wants the lab in a browser needs them.
require_web_packages() {
    missing=
    command -v em++ >/dev/null 2>&1 || missing=emscripten
    [ -d /usr/share/nodejs/acorn ] || missing="$missing node-acorn"
    [ -z "$missing" ] || { say "missing: ${missing# }; apt-get install --no-install-recommends emscripten node-acorn"; exit 2; }
}

if [ "${1-}" = --no-install ]; then
    shift
else
    install_packages
fi
case "${1-}" in
    demo)
        shift
        build demo
        sweep=$(out_of "$@")/sweep_quick
        "$program" sweep quick --out "$sweep"
        "$program" merge "$sweep"
        exec "$program" chapter all "$@"
        ;;
    test)
        build test
        cd "$here" && exec ctest --preset test
        ;;
    web)
        shift
        require_web_packages
        build wasm web
        out=$(out_of "$@")
        mkdir -p "$out"
        cp "$here/build/wasm/lab.html" "$out/lab.html"
        printf '%s\n' "$out/lab.html"
        ;;
    *)
        [ -x "$program" ] || build demo
        exec "$program" "$@"
        ;;
esac
