# shellcheck shell=bash
# For the scripts that make collages, which source it.

# make_collage COMMAND...: runs a command that ends as `tessera collage` does. Its exit code 3 (done, but pieces are
# missing that the job counts) is said and taken as done.
make_collage() {
  local status=0
  "$@" || status=$?
  if [[ $status -eq 3 ]]; then
    echo "done, but pieces are missing: the warnings above and card.txt name them (exit code 3)" >&2
    return 0
  fi
  return "$status"
}
