#!/bin/sh
# Compares other stripifiers with ours: run.sh MESH... prints the tables of strips_table with a row for each peer.
# Builds the peers whose libraries are installed and lists the missing ones; installs nothing. See README.md.
set -eu
[ $# -gt 0 ] || { echo "usage: run.sh MESH..." >&2; exit 1; }
here=$(cd "$(dirname "$0")" && pwd)
work=${PEERS_DIR:-$(mktemp -d)}
python=${PYTHON:-python3}
mkdir -p "$work"
[ -n "${PEERS_DIR:-}" ] || trap 'rm -rf "$work"' EXIT

cargo bench --quiet --manifest-path "$here/../../Cargo.toml" --bench strips_table -- --write-lists "$work" "$@"

build() { # NAME LIBRARIES...
    name=$1
    shift
    if ${CXX:-c++} -std=c++17 -O2 -DNDEBUG -o "$work/$name" "$here/$name.cpp" "$@" 2>"$work/$name.log"; then
        tools="$tools $name"
    elif grep -q 'fatal error: .*No such file' "$work/$name.log"; then
        echo "$name: not installed, skipped" >&2
    else
        cat "$work/$name.log" >&2
        exit 1
    fi
}
offer() { # NAME MODULE
    if "$python" -c "import numpy, $2" 2>/dev/null; then
        printf '#!/bin/sh\nexec "%s" "%s" "$@"\n' "$python" "$here/$1.py" >"$work/$1"
        chmod +x "$work/$1"
        tools="$tools $1"
    else
        echo "$1: not installed, skipped" >&2
    fi
}
tools=
build openmesh -lOpenMeshTools -lOpenMeshCore
build draco -ldraco
build tri_stripper -losgUtil -losg -lOpenThreads
offer vtk_strips vtkmodules.vtkFiltersCore
offer nvtristrip pyffi.utils.tristrip

for list in "$work"/*.triangles; do
    for tool in $tools; do
        timeout "${PEER_SECS:-300}" "$work/$tool" "$list" "${list%.triangles}.$tool.strips" >&2 ||
            echo "$tool: no strips of $list within ${PEER_SECS:-300} s" >&2
    done
done
cargo bench --quiet --manifest-path "$here/../../Cargo.toml" --bench strips_table -- --peers "$work" ${QUICK:+--quick} "$@"
