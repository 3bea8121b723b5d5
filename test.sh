#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds everything, and runs all tests.
set -euo pipefail
cd "$(dirname "$0")"

scripts/install.sh

cmake --preset release >/dev/null
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
