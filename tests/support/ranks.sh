# shellcheck shell=bash disable=SC2154,SC2034
# For the tests that are shell scripts, which source it: "${on_ranks[@]}" 3 COMMAND... on three ranks of this machine,
# whatever it has of processors. Needs: $mpirun.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
on_ranks=("${mpirun-}" -q --oversubscribe --bind-to none -n)  # -q: nothing of mpirun's own about exit codes
