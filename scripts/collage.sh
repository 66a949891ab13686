# shellcheck shell=bash
# Scripts that make collages source this file.

# make_collage COMMAND...: runs a command that ends as `tessera collage` does. Exit code 3 means done, but required pieces are missing; it
# is reported and counts as success.
make_collage() {
  local status=0
  "$@" || status=$?
  if [[ $status -eq 3 ]]; then
    echo "done, but pieces are missing: the warnings above and card.txt name them (exit code 3)" >&2
    return 0
  fi
  return "$status"
}
