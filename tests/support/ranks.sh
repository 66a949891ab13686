# shellcheck shell=bash disable=SC2154,SC2034
# For the tests that are shell scripts, which source it: "${on_ranks[@]}" 3 COMMAND... on three ranks of this machine,
# whatever it has of processors. Needs: $mpirun.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
on_ranks=("${mpirun-}" -q --oversubscribe --bind-to none -n)  # -q: nothing of mpirun's own about exit codes

# without_launcher_warnings FILE: FILE without the lines that mpirun's event loop writes by itself, where a rank that
# was killed closes its end of a pipe at the wrong moment: "[warn] Epoll MOD(1) on fd 26 failed. ..." They are of the
# launcher, not of the job, and no option of mpirun silences them.
without_launcher_warnings() {
  sed -i '/^\[warn\] /d' "$1"
}
