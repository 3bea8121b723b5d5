#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# From a bare Debian 12 to pictures: installs what is missing, builds texgraph, compiles every graph under graphs/ and renders it.
# The results are in out/.
set -euo pipefail
cd "$(dirname "$0")"

scripts/install.sh
cmake --preset release >/dev/null
cmake --build --preset release --target texgraphc texgraph

bin=build/release/bin
mkdir -p out
shopt -s nullglob
for graph in graphs/*/*.json graphs/*/*.jsonc graphs/*/*.yaml; do
  name=$(basename "${graph%.*}")
  "$bin/texgraphc" "$graph" -o "out/$name.frag"
  "$bin/texgraph" render "$graph" -o "out/$name.png"
  echo "$graph: shader out/$name.frag, manifest out/$name.json, picture out/$name.png"
done
echo
echo "The pictures and shaders are in $PWD/out; begin with out/brick_wall.png."
