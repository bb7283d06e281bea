#!/usr/bin/env bash
# Installs missing packages, builds the command in build/, and shows the Delassus solver beside
# stock Bullet.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash .ci/setup.sh
echo "== build: Release, the command alone, in build/"
tests=OFF  # unless they are built already
if grep -qs '^DELASSUS_TESTS:BOOL=ON' build/CMakeCache.txt; then tests=ON; fi
cmake --preset release -DDELASSUS_TESTS=$tests -DDELASSUS_{BULLET,MULTIBODY,DEMOS,RENDER}=ON --log-level=WARNING
cmake --build --preset release --parallel "$(nproc)" --target delassus_command -- --quiet

command=build/demos/delassus
echo "== stack_10_heavy_top: nine boxes of 1 kg under one of 1000 kg"
$command run stack_10_heavy_top --solver delassus,si:10,dantzig:1e-6

# Dantzig's time grows with the cube of the number of contacts: it gets a minute a world.
for world in ../shared/worlds/*.bullet; do
  [ -e "$world" ] || continue
  echo "== $(basename "$world")"
  $command run "$world" --solver delassus,si:10 --seconds 4
  timeout 60 $command run "$world" --solver dantzig:1e-6 --seconds 4 || {
    status=$?
    [ $status -eq 124 ] || exit $status
    echo "dantzig:1e-6 on $(basename "$world"): stopped after a minute of computing"
  }
done

echo "== a picture: delassus beside stock Bullet"
$command render stack_10_heavy_top --solver delassus,si:10 --at 0.8 --out build/renders
