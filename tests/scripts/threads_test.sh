#!/usr/bin/env bash
# threads_test.sh: only the files of src/ in the list below make threads, use OpenCV's threads, or count the machine's cores; the list gives
# the reasons.
# All other computations use the rank's pool (core/base/rank_pool.h).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../src"

allowed=$(sed 's/ .*//' <<'END'
artwork/drawers/drawers.cpp            each waits for the drawer that it started
comm/heartbeat.h                       waits for the next heartbeat
comm/watchdog.h                        waits for the clock
core/base/rank_pool.cpp                counts cores where the affinity is not known
core/base/task_pool.cpp                the pool itself
core/base/task_pool.h
core/replacing/replaced_windows.cpp    computes in the place of the thread that asks, which only looks
files/work_in_order.h                  they wait for drawers and files
products/elements/candidate_maps.cpp   OpenCV's loops, whose bodies are OpenCV's functions
products/elements/segmentation/region_vote.cpp
render/pieces/stop_watcher.cpp         waits for the clock
render/pieces/stop_watcher.h
serve/refinement.cpp                   reads what a process prints, until its end
serve/refinement.h
worker/devices/opencl_devices.cpp      as many as PoCL will start: they end at once
worker/shard/device_library.cpp        waits for the disk
END
)
found=$(grep -rlE --include='*.cpp' --include='*.h' 'std::j?thread\b|std::async|hardware_concurrency|pthread_create|parallel_for_\(' . |
  sed 's|^\./||' | LC_ALL=C sort)
if ! diff <(echo "$allowed") <(echo "$found") >&2; then
  echo "threads_test.sh: < is listed and makes no thread, > makes threads and is not listed" >&2
  exit 1
fi
