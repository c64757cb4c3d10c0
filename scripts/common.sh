# Read by the scripts beside it: where things are, and how to say what is going on.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${INFRADIANCE_BUILD:-$root/build}

say() { printf '\n== %s\n' "$*"; }
fail() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
    exit 1
}

# Runs a command whose output matters only when it fails.
quietly() {
    local log status=0
    log=$(mktemp)
    "$@" >"$log" 2>&1 || status=$?
    [ "$status" -eq 0 ] || cat "$log" >&2
    rm -f "$log"
    [ "$status" -eq 0 ] || fail "'$*' ended with status $status"
}

# Configures and builds the release preset's tree: build_all [cmake argument...]
build_all() {
    say "Building in $build (minutes the first time, seconds afterwards)"
    quietly cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@"
    local start=$SECONDS
    quietly cmake --build "$build" --parallel
    echo "Programs are in $build/bin ($((SECONDS - start)) s)."
}
