// Kinds of files and file systems in words, for messages.
#pragma once

#include <sys/stat.h>

#include <string>

namespace tessera {

/// The kind in st_mode: "a folder", "a pipe", "a socket", "a link", "a device", "a regular file".
std::string file_kind(mode_t mode);

/// "proc", "sysfs" and so on where `magic` (statfs(2), f_type) is a file system whose files the kernel makes up when
/// they are read: reading may wait for ever (/proc/kmsg) or change the machine. Empty for a file system of ordinary
/// files.
std::string kernel_file_system(long magic);

}  // namespace tessera
