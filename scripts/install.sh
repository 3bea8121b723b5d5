#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Installs what texgraph needs from Debian 12, if anything is missing. Without a missing package it asks nobody and needs no
# network. The only list of packages: demo.sh and test.sh call this.
set -euo pipefail

packages=(
  # tools
  cmake g++ ninja-build
  # the compiler and its command line
  glslang-dev libboost-dev libcli11-dev libfmt-dev libfyaml-dev libkissfft-dev spirv-tools
  # the renderer
  libegl-dev libgl-dev libgl1-mesa-dri libegl1 libglm-dev libjpeg-dev libopenexr-dev libosmesa6
  libpng-dev libtinygltf-dev zlib1g-dev
  # tests and benchmarks
  glslang-tools libbenchmark-dev libgmock-dev libgtest-dev libvalijson-dev nlohmann-json3-dev spirv-headers
)

missing=()
for package in "${packages[@]}"; do
  if [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
    missing+=("$package")
  fi
done
if (( ${#missing[@]} == 0 )); then
  exit 0
fi

as_root=()
if (( EUID != 0 )); then
  if ! command -v sudo >/dev/null; then
    echo "install.sh: these packages are missing, and only root or sudo can install them: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "installing: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
