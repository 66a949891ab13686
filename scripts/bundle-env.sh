# shellcheck shell=bash
# env.sh of a bundle (scripts/gpu-bundle.sh). Source it with bash.
# The bundle's programs, libraries and Open MPI come first.
# OpenCL finds the library of this machine's driver, wherever it lies. Without one it uses the bundle's PoCL, if pocl.tar.xz was unpacked,
# too.
# BUNDLE_POCL=1 always selects PoCL. OCL_ICD_VENDORS, if already set, takes precedence.
bundle=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export PATH=$bundle/bin:$PATH LD_LIBRARY_PATH=$bundle/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
# Open MPI and its PMIx were built for /usr.
export OPAL_PREFIX=$bundle
export PMIX_PKGLIBDIR=$bundle/lib/x86_64-linux-gnu/pmix2/lib/pmix PMIX_PKGDATADIR=$bundle/share/pmix
# Some containers forbid the system call that this mechanism uses.
export OMPI_MCA_btl_vader_single_copy_mechanism=none
# Without ssh mpirun refuses to start even ranks of this machine, unless it is told that there are no other machines.
command -v ssh rsh >/dev/null || export OMPI_MCA_plm=isolated

[[ -e /etc/fonts/fonts.conf ]] || export FONTCONFIG_FILE=${FONTCONFIG_FILE:-$bundle/share/fonts/fonts.conf}

# vendor_opencl: prints the OpenCL libraries of the drivers on this machine, one path a line.
vendor_opencl() {
  {
    PATH=$PATH:/sbin:/usr/sbin ldconfig -p 2>/dev/null | awk '/lib(nvidia-opencl|amdocl64|igdrcl)\.so/ { print $NF }'
    find /usr/local/nvidia /usr/lib/x86_64-linux-gnu /usr/lib64 /usr/local/cuda/compat /opt/rocm/lib -maxdepth 3 \
      \( -name 'libnvidia-opencl.so*' -o -name 'libamdocl64.so*' -o -name 'libigdrcl.so*' \) 2>/dev/null
  } | xargs -r -n 1 readlink -f | sort -u
}

# listed_opencl: prints the libraries that the files of /etc/OpenCL/vendors name.
listed_opencl() { cat /etc/OpenCL/vendors/*.icd 2>/dev/null; }

# unlisted_opencl: prints the first driver's library that none of these files names, as happens in containers.
unlisted_opencl() {
  local library name
  while read -r library; do
    name=${library##*/}
    grep -qF "${name%%.so*}.so" <(listed_opencl) || { echo "$library"; return; }
  done < <(vendor_opencl)
}

# choose_opencl: sets OCL_ICD_VENDORS if the usual list does not fit. The loader also accepts a library's path there.
choose_opencl() {
  local unlisted pocl=$bundle/pocl/lib/x86_64-linux-gnu
  [[ -z ${OCL_ICD_VENDORS-} ]] || return 0
  unlisted=$(unlisted_opencl)
  if [[ ${BUNDLE_POCL-} == 1 || -z $unlisted$(listed_opencl) && -d $pocl ]]; then
    export OCL_ICD_VENDORS=$pocl/libpocl.so.2 LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$pocl PATH=$PATH:$bundle/pocl/bin
  elif [[ -n $unlisted ]]; then
    # The driver's compiler lies in the same folder.
    export OCL_ICD_VENDORS=$unlisted LD_LIBRARY_PATH=$LD_LIBRARY_PATH:${unlisted%/*}
  fi
}
choose_opencl
