// Computes single operations and returns the bits of their results; the host compares them with those that IEEE 754
// demands (src/worker/devices/arithmetic_probe.h). It is part of the same program as the other kernels, so that the
// device's compiler treats it like them.

kernel void probe_arithmetic(uint count, global const ProbeRecord* probes, global uint* results) {
  const uint i = get_global_id(0);
  if (i >= count) return;
  const ProbeRecord probe = probes[i];
  const float a = as_float(probe.a);
  const float b = as_float(probe.b);
  const float c = as_float(probe.c);
  uint result = 0;
  switch (probe.operation) {
    case kProbeProductAndSum: result = as_uint(a * b + c); break;
    case kProbeProductAndDifference: result = as_uint(a * b - c); break;
    case kProbeProduct: result = as_uint(a * b); break;
    case kProbeQuotient: result = as_uint(a / b); break;
    case kProbeRoot: result = as_uint(sqrt(a)); break;
    case kProbeSum: result = as_uint(a + b + c); break;
    case kProbeFromInt: result = as_uint((float)(int)probe.a); break;
    case kProbeFromUint: result = as_uint((float)probe.a); break;
    case kProbeToInt: result = (uint)(int)a; break;
    case kProbeFloor: result = as_uint(floor(a)); break;
  }
  results[i] = result;
}
