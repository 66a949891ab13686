# shellcheck shell=bash disable=SC2154,SC2034
# Tests that are shell scripts source this file. It needs $mpirun.
# "${on_ranks[@]}" 3 COMMAND... runs COMMAND on three ranks of this machine, whatever its number of processors.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
on_ranks=("${mpirun-}" -q --oversubscribe --bind-to none -n)  # -q: mpirun prints no messages of its own about exit codes

# without_launcher_warnings FILE: prints FILE without the warnings of mpirun's event loop.
# A killed rank that closes its end of a pipe at a bad moment causes them: "[warn] Epoll MOD(1) on fd 26 failed. ..."
# They say nothing about the job, and no option of mpirun silences them.
without_launcher_warnings() {
  sed -i '/^\[warn\] /d' "$1"
}
