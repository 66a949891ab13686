# shellcheck shell=bash disable=SC2034
# To be sourced: the surroundings in which the programs of a bundle run (scripts/gpu-bundle.sh), and the machine's own
# OpenCL library, wherever the vendor's driver lies. BUNDLE_POCL=1: the bundle's PoCL instead.
bundle=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export PATH=$bundle/bin:$PATH
export OPAL_PREFIX=$bundle PMIX_INSTALL_PREFIX=$bundle
export OMPI_MCA_btl_base_warn_component_unused=0 OMPI_MCA_btl_vader_single_copy_mechanism=none

# vendor_opencl: the paths of OpenCL libraries of drivers on this machine, one a line.
vendor_opencl() {
  {
    ldconfig -p 2>/dev/null | awk '/lib(nvidia-opencl|amdocl64|igdrcl)\.so/ { print $NF }'
    find /usr/local/nvidia /usr/lib/x86_64-linux-gnu /usr/lib64 /usr/local/cuda/compat /opt/rocm/lib -maxdepth 3 \
      -name 'libnvidia-opencl.so*' -o -maxdepth 3 -name 'libamdocl64.so*' 2>/dev/null
  } | xargs -r -n 1 readlink -f | sort -u
}

driver_folders=
for folder in /usr/local/nvidia/lib64 /usr/local/nvidia/lib; do
  [[ ! -d $folder ]] || driver_folders+=:$folder
done
export LD_LIBRARY_PATH=$bundle/lib$driver_folders${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}

# A folder of its own for the list of implementations: where the bundle lies may be read-only.
vendors=${TMPDIR:-/tmp}/tessera-vendors.$UID.$$
mkdir -p "$vendors"
if [[ ${BUNDLE_POCL-} == 1 ]]; then
  echo "$bundle/pocl/lib/x86_64-linux-gnu/libpocl.so.2" >"$vendors/pocl.icd"
  export LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$bundle/pocl/lib/x86_64-linux-gnu PATH=$PATH:$bundle/pocl/bin
else
  for library in $(vendor_opencl); do
    echo "$library" >"$vendors/$(basename "$library").icd"
  done
fi
export OCL_ICD_VENDORS=$vendors
