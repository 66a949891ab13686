#include "files/file_kind.h"

#include <linux/magic.h>

#include <algorithm>
#include <array>

namespace tessera {
namespace {

struct KernelFileSystem {
  long magic;
  const char* name;
};

// The plain numbers are in the kernel's sources, but not in <linux/magic.h>.
constexpr std::array kKernelFileSystems = {KernelFileSystem{PROC_SUPER_MAGIC, "proc"},
                                           KernelFileSystem{SYSFS_MAGIC, "sysfs"},
                                           KernelFileSystem{DEBUGFS_MAGIC, "debugfs"},
                                           KernelFileSystem{TRACEFS_MAGIC, "tracefs"},
                                           KernelFileSystem{SECURITYFS_MAGIC, "security"},
                                           KernelFileSystem{CGROUP_SUPER_MAGIC, "cgroup"},
                                           KernelFileSystem{CGROUP2_SUPER_MAGIC, "cgroup"},
                                           KernelFileSystem{BPF_FS_MAGIC, "bpf"},
                                           KernelFileSystem{PSTOREFS_MAGIC, "pstore"},
                                           KernelFileSystem{EFIVARFS_MAGIC, "efivarfs"},
                                           KernelFileSystem{SELINUX_MAGIC, "selinux"},
                                           KernelFileSystem{SMACK_MAGIC, "smack"},
                                           KernelFileSystem{BINFMTFS_MAGIC, "binfmt_misc"},
                                           KernelFileSystem{NSFS_MAGIC, "nsfs"},
                                           KernelFileSystem{RDTGROUP_SUPER_MAGIC, "resctrl"},
                                           KernelFileSystem{0x62656570, "configfs"},
                                           KernelFileSystem{0x19800202, "mqueue"},
                                           KernelFileSystem{0x65735543, "fusectl"},
                                           KernelFileSystem{0x6e667364, "nfsd"},
                                           KernelFileSystem{0x67596969, "rpc_pipefs"}};

}  // namespace

std::string file_kind(mode_t mode) {
  if (S_ISREG(mode)) return "a regular file";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  if (S_ISLNK(mode)) return "a link";
  return "a device";
}

std::string kernel_file_system(long magic) {
  const auto at = std::find_if(kKernelFileSystems.begin(), kKernelFileSystems.end(),
                               [&](const KernelFileSystem& system) { return system.magic == magic; });
  return at == kKernelFileSystems.end() ? "" : at->name;
}

}  // namespace tessera
