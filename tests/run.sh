#!/usr/bin/env bash
# Installs missing packages, builds Release in build/, runs every test that is not labelled slow, in
# both precisions. Further arguments go to ctest, e.g. `bash tests/run.sh -R residual`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash .ci/setup.sh tests
echo "== build: Release, in build/"
cmake --preset release -DDELASSUS_{BULLET,MULTIBODY,DEMOS,RENDER,TESTS}=ON --log-level=WARNING
cmake --build --preset release --parallel "$(nproc)" -- --quiet
echo "== tests"
ctest --preset release --parallel "$(nproc)" --progress "$@"
