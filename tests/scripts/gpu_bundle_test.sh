#!/usr/bin/env bash
# gpu_bundle_test.sh FOLDER: makes both archives of scripts/gpu-bundle.sh. Runs gpu-check in a root folder that has only the C library and a
# few commands.
# With the first archive alone there is no device; with both all checks pass.
# The test is skipped (77) if this user may not change the root. It takes minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=$1

if [[ $EUID -eq 0 ]]; then enter=(unshare --mount); else enter=(unshare --map-root-user --mount); fi
"${enter[@]}" true 2>/dev/null || { echo "SKIPPED: unshare --mount is not allowed"; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"
root=$(readlink -f "$folder")/root

# The root folder holds the commands, the libraries that they load, and all of glibc, whose parts load each other by name.
commands=(awk basename bash cat chmod cmp cp cut date diff dirname env find grep gzip head hostname id ldconfig ldd ls
  mkdir mktemp mv nproc readlink rm sed sh sha256sum sleep sort tail tar tee timeout touch tr uname wc xargs xz)
mkdir -p "$root"/{usr/bin,usr/lib,usr/lib64,proc,sys,dev,tmp,root,etc}
ln -s usr/bin usr/lib usr/lib64 "$root/"
ln -s usr/bin "$root/sbin"
for command in "${commands[@]}"; do
  command=$(PATH=$PATH:/sbin:/usr/sbin command -v "$command")
  cp -L "$command" "$root/usr/bin/"
  { ldd "$command" 2>/dev/null || true; } | { grep -oE '/[^ ]+\.so[^ ]*' || true; } | while read -r library; do
    mkdir -p "$root${library%/*}"
    cp -L "$library" "$root$library"
  done
done
dpkg -L libc6 | grep -E '^(/usr)?/lib/x86_64-linux-gnu/.*\.so' | while read -r library; do
  [[ ! -f $library ]] || { mkdir -p "$root${library%/*}"; cp -L "$library" "$root$library"; }
done

# in_root COMMAND: runs COMMAND in that root, without this machine's environment.
in_root() {
  # shellcheck disable=SC2016  # the inner shell expands them
  "${enter[@]}" bash -c 'for place in proc sys dev; do mount --rbind "/$place" "$1/$place"; done
    exec chroot "$1" /usr/bin/env -i HOME=/root PATH=/usr/bin:/bin bash -c "$2"' _ "$root" "$1"
}
fail() {
  echo "FAILED $1"
  exit 1
}

scripts/gpu-bundle.sh "$folder"
[[ $(stat -c %s "$folder/bundle.tar.xz") -le 40000000 ]] || fail "bundle.tar.xz is larger than 40 MB"
mkdir "$root/opt"
tar -C "$root/opt" -xf "$folder/bundle.tar.xz"
code=0
said=$(in_root '/opt/bundle/gpu-check.sh /opt/bundle /root/alone' 2>&1) || code=$?
[[ $code == 1 && $(grep -c 'There is no OpenCL device' <<<"$said") == 1 ]] || fail "without a device: $code, $said"
tar -C "$root/opt" -xf "$folder/pocl.tar.xz"
in_root '/opt/bundle/gpu-check.sh /opt/bundle /root/both --minutes 40' || fail "with PoCL"
rm -rf "$root"
