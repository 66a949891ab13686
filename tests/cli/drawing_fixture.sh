# shellcheck shell=bash disable=SC2154
# Tests of drawing source this file after restart_fixture.sh. It has a job whose pictures take a while.
# The folder "expected" gets the result of an undisturbed run.
make_drawn_job() { # TRIALS WIDTH_PX
  make_job "$1"
  sed -i "s/width_px = 240/width_px = $2/" job.toml
  printf '[colour]\npieces = "artwork"\n' >>job.toml  # the artwork, not silhouettes, though all drawings have one colour
  run_ms=$(date +%s%3N)
  start 1 expected --set checkpoint.every_s=0
  expect_end 0 "the undisturbed run"
  run_ms=$(($(date +%s%3N) - run_ms))
}

# Expects the bytes of the undisturbed run and no half-written file.
expect_drawn() { # OUT
  local name
  for name in pieces.geojson collage.png collage.svg; do
    cmp "expected/$name" "$1/$name" || fail "$1/$name is another one"
  done
  [[ -z $(find "$1" -name '*.tmp' -o -name 'checkpoint*') ]] || fail "$1: leftovers"
}

# Waits for the result of $started, which then begins to draw.
wait_for_manifest() { # OUT
  until [[ -e $1/manifest.json ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.005; done
}
