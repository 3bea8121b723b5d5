#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds everything, and runs all tests; before that the unit tests with the address and
# undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")"

scripts/install.sh

cmake --preset sanitize >/dev/null
cmake --build --preset sanitize --target unit_tests
ctest --preset sanitize --parallel "$(nproc)"

cmake --preset release >/dev/null
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
