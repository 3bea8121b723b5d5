#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds everything and runs all tests; then the unit tests once more with the address and
# undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")"

scripts/install.sh

cmake --preset release >/dev/null
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"

cmake --preset sanitize >/dev/null
cmake --build --preset sanitize --target unit_tests
ctest --preset sanitize --parallel "$(nproc)"
