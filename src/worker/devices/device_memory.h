// Allocates the memory of a device's buffers.
#pragma once

#include <CL/opencl.hpp>
#include <cstddef>

namespace tessera::worker {

/// Makes a buffer for reading and writing. On a CPU a large buffer lies in huge pages, where the system has them. An index
/// of a hundred thousand shapes is 0.8 GB: to touch so many small pages for the first time takes as long as to fill them.
/// Throws cl::Error.
cl::Buffer make_device_buffer(const cl::Context& context, const cl::Device& device, std::size_t bytes);

}  // namespace tessera::worker
