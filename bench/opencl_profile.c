// Where the time of a program's OpenCL goes, by a library that is loaded before it:
//   LD_PRELOAD=build/release/bench/libopencl_profile.so tessera ...
// At the end of the program a table on standard error: each kernel's launches and times on the device, copies, and how
// long the host waited in each call.
#define _GNU_SOURCE
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { kMostRows = 64, kMostPending = 4096, kNameRoom = 48 };

typedef struct {
  char name[kNameRoom];
  unsigned long calls;
  unsigned long long device_ns, longest_ns, host_ns, bytes;
} Row;

static Row rows[kMostRows];
static int row_count;
static struct {
  cl_event event;
  int row;
} pending[kMostPending];
static int pending_count;
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static unsigned long long started_ns;

static unsigned long long now_ns(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (unsigned long long)t.tv_sec * 1000000000ull + (unsigned long long)t.tv_nsec;
}

static int row_of(const char* name) {
  for (int i = 0; i < row_count; ++i) {
    if (strcmp(rows[i].name, name) == 0) return i;
  }
  if (row_count == kMostRows) return kMostRows - 1;
  strncpy(rows[row_count].name, name, kNameRoom - 1);
  return row_count++;
}

// The times of commands that are done.
static void drain(void) {
  int left = 0;
  for (int i = 0; i < pending_count; ++i) {
    cl_int status = CL_QUEUED;
    clGetEventInfo(pending[i].event, CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof status, &status, NULL);
    if (status > CL_COMPLETE) {
      pending[left++] = pending[i];
      continue;
    }
    cl_ulong begin = 0, end = 0;
    clGetEventProfilingInfo(pending[i].event, CL_PROFILING_COMMAND_START, sizeof begin, &begin, NULL);
    clGetEventProfilingInfo(pending[i].event, CL_PROFILING_COMMAND_END, sizeof end, &end, NULL);
    Row* row = rows + pending[i].row;
    row->device_ns += end - begin;
    if (end - begin > row->longest_ns) row->longest_ns = end - begin;
    clReleaseEvent(pending[i].event);
  }
  pending_count = left;
}

static void count(const char* name, unsigned long long host_ns, unsigned long long bytes, cl_event event,
                  int all_are_done) {
  pthread_mutex_lock(&mutex);
  const int row = row_of(name);
  ++rows[row].calls;
  rows[row].host_ns += host_ns;
  rows[row].bytes += bytes;
  if (event && pending_count < kMostPending) {
    pending[pending_count].event = event;
    pending[pending_count++].row = row;
  } else if (event) {
    clReleaseEvent(event);
  }
  if (all_are_done || pending_count == kMostPending) drain();
  pthread_mutex_unlock(&mutex);
}

__attribute__((constructor)) static void begin(void) { started_ns = now_ns(); }

__attribute__((destructor)) static void report(void) {
  if (row_count == 0) return;
  fprintf(stderr, "OpenCL of a process, %.2f s:\n", 1e-9 * (double)(now_ns() - started_ns));
  fprintf(stderr, "%-26s %8s %12s %10s %12s %12s %10s\n", "call", "times", "device ms", "mean us", "longest us",
          "in call ms", "MB");
  for (int i = 0; i < row_count; ++i) {
    const Row* r = rows + i;
    fprintf(stderr, "%-26s %8lu %12.1f %10.1f %12.1f %12.1f %10.1f\n", r->name, r->calls, 1e-6 * (double)r->device_ns,
            1e-3 * (double)r->device_ns / (double)r->calls, 1e-3 * (double)r->longest_ns, 1e-6 * (double)r->host_ns,
            1e-6 * (double)r->bytes);
  }
}

// POSIX lets a function's address be a void pointer, which ISO C does not: hence __extension__.
#define REAL(name)               \
  static __typeof__(&name) real; \
  if (!real) real = __extension__(__typeof__(&name)) dlsym(RTLD_NEXT, #name)

// The caller's event, where it wants one, and our own reference to it.
#define WITH_EVENT(call)                             \
  cl_event own = NULL;                               \
  cl_event* const event = wanted ? wanted : &own;    \
  const unsigned long long before = now_ns();        \
  const cl_int code = call;                          \
  const unsigned long long took = now_ns() - before; \
  if (code == CL_SUCCESS && wanted) clRetainEvent(*wanted)

cl_command_queue clCreateCommandQueue(cl_context context, cl_device_id device, cl_command_queue_properties properties,
                                      cl_int* error) {
  REAL(clCreateCommandQueue);
  return real(context, device, properties | CL_QUEUE_PROFILING_ENABLE, error);
}

cl_int clBuildProgram(cl_program program, cl_uint n, const cl_device_id* devices, const char* options,
                      void(CL_CALLBACK* notify)(cl_program, void*), void* data) {
  REAL(clBuildProgram);
  const unsigned long long before = now_ns();
  const cl_int code = real(program, n, devices, options, notify, data);
  count("(building)", now_ns() - before, 0, NULL, 0);
  return code;
}

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions, const size_t* offset,
                              const size_t* global, const size_t* local, cl_uint waits, const cl_event* wait_list,
                              cl_event* wanted) {
  REAL(clEnqueueNDRangeKernel);
  WITH_EVENT(real(queue, kernel, dimensions, offset, global, local, waits, wait_list, event));
  char name[kNameRoom] = "";
  clGetKernelInfo(kernel, CL_KERNEL_FUNCTION_NAME, sizeof name - 1, name, NULL);
  if (code == CL_SUCCESS) count(name, took, 0, *event, 0);
  return code;
}

cl_int clEnqueueReadBuffer(cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t size,
                           void* to, cl_uint waits, const cl_event* wait_list, cl_event* wanted) {
  REAL(clEnqueueReadBuffer);
  WITH_EVENT(real(queue, buffer, blocking, offset, size, to, waits, wait_list, event));
  if (code == CL_SUCCESS) count("(reading)", took, size, *event, blocking);
  return code;
}

cl_int clEnqueueWriteBuffer(cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t size,
                            const void* from, cl_uint waits, const cl_event* wait_list, cl_event* wanted) {
  REAL(clEnqueueWriteBuffer);
  WITH_EVENT(real(queue, buffer, blocking, offset, size, from, waits, wait_list, event));
  if (code == CL_SUCCESS) count(blocking ? "(writing)" : "(writing, posted)", took, size, *event, 0);
  return code;
}

cl_int clEnqueueWriteBufferRect(cl_command_queue queue, cl_mem buffer, cl_bool blocking, const size_t* at,
                                const size_t* host_at, const size_t* region, size_t row, size_t slice, size_t host_row,
                                size_t host_slice, const void* from, cl_uint waits, const cl_event* wait_list,
                                cl_event* wanted) {
  REAL(clEnqueueWriteBufferRect);
  WITH_EVENT(real(queue, buffer, blocking, at, host_at, region, row, slice, host_row, host_slice, from, waits,
                  wait_list, event));
  if (code == CL_SUCCESS) count("(writing a rectangle)", took, region[0] * region[1], *event, 0);
  return code;
}

cl_int clEnqueueFillBuffer(cl_command_queue queue, cl_mem buffer, const void* pattern, size_t pattern_size,
                           size_t offset, size_t size, cl_uint waits, const cl_event* wait_list, cl_event* wanted) {
  REAL(clEnqueueFillBuffer);
  WITH_EVENT(real(queue, buffer, pattern, pattern_size, offset, size, waits, wait_list, event));
  if (code == CL_SUCCESS) count("(filling)", took, size, *event, 0);
  return code;
}

cl_int clWaitForEvents(cl_uint n, const cl_event* events) {
  REAL(clWaitForEvents);
  const unsigned long long before = now_ns();
  const cl_int code = real(n, events);
  count("(waiting for launches)", now_ns() - before, 0, NULL, 0);
  return code;
}

cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, size_t size, void* host, cl_int* error) {
  REAL(clCreateBuffer);
  const unsigned long long before = now_ns();
  const cl_mem buffer = real(context, flags, size, host, error);
  count("(making buffers)", now_ns() - before, size, NULL, 0);
  return buffer;
}
