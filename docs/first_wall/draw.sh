#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Draws the pictures of docs/from-layers-to-shader.md anew, with the texgraph on the path; pngquant makes them small.
set -euo pipefail
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cp ./*.json ../../graphs/first_wall/*.png "$work"

draw() {  # draw NAME GRAPH OPTION...
  texgraph render "$work/$2.json" -q -o "$work/drawn.png" "${@:3}"
  pngquant --force --speed 1 --output "../pictures/first_wall/$1.png" 128 "$work/drawn.png"
}
for n in 1 2 3 4 5 6 7; do draw "step_$n" "step_$n" --size 400; done
draw wall step_8 --size 400 --mesh wall
draw sphere step_8 --size 400 --mesh sphere --tile 2
draw far_without step_8 --size 400 --uv 0,0,20,20
draw far_with step_9 --size 400 --uv 0,0,20,20
draw growing step_10 --size 200 --contact-sheet --sweep ivy --frames 4
