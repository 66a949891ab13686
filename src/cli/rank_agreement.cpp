#include "cli/rank_agreement.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "io/job/colour_image.h"
#include "worker/kernel_options.h"

namespace tessera::cli {
namespace {

comm::Bytes to_bytes(const std::string& text) { return {text.begin(), text.end()}; }

std::string receive_text(comm::Communicator& ranks) {
  const comm::Bytes bytes = ranks.broadcast({});
  return {bytes.begin(), bytes.end()};
}

std::string hex(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

std::string kernel_digest() {
  Digest digest;
  digest.add_all(std::span<const char>(std::string_view(worker::kernel_source)));
  return hex(digest.value());
}

/// Comes back from strtod to the bit.
std::string exact_text(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%a", value);
  return text;
}

}  // namespace

std::string program_identity() {
  return std::string("tessera ") + program_version() + ", commit " + program_commit() + ", kernels " + kernel_digest();
}

// Each as a text of its own, the program first: programs that differ need to agree about nothing else.
void announce_run(comm::Communicator& ranks, const std::string& program, const io::Job& job,
                  std::uint64_t library_digest) {
  ranks.broadcast(to_bytes(program));
  ranks.broadcast(to_bytes(io::to_toml(job)));
  ranks.broadcast(to_bytes(exact_text(job.size_factor)));
  ranks.broadcast(to_bytes(hex(library_digest)));
}

io::Job receive_job(comm::Communicator& ranks, const std::string& program) {
  const std::string masters_program = receive_text(ranks);
  if (program != masters_program) {
    throw EnvironmentError("this rank runs " + program + ", the master " + masters_program +
                           "; allowed: the same program on all ranks; install it anew on every node");
  }
  const std::string masters_job = receive_text(ranks);
  io::Job job = io::job_from_toml(masters_job, "the master's job");
  if (io::to_toml(job) != masters_job) {
    throw EnvironmentError(
        "this rank understands the master's job otherwise than the master; install the same program "
        "and the same libraries on every node");
  }
  job.size_factor = std::strtod(receive_text(ranks).c_str(), nullptr);
  return job;
}

void check_library(comm::Communicator& ranks, const io::ShapeLibrary& library) {
  const std::string masters = receive_text(ranks);
  const std::string own = hex(library.content_digest());
  if (own == masters) return;
  throw InputError(library.path() + ": another library than the master's of this name (digest of the content " + own +
                   ", the master's " + masters +
                   "); all ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

// The finest level alone: the others follow from it.
void announce_colours(comm::Communicator& ranks, const io::Job& job) {
  const ColourWish& colour = job.settings.colour;
  ranks.broadcast(to_bytes(hex(job.colour_digest)));
  if (!colour.target) return;
  const ColourLevel& finest = colour.target->levels().front();
  ranks.broadcast(to_bytes(std::to_string(finest.width) + " " + std::to_string(finest.height) + " " +
                           exact_text(colour.target->px_per_texel())));
  const char* const texels = reinterpret_cast<const char*>(colour.target->texels().data());
  ranks.broadcast({texels, texels + std::size_t(finest.width) * finest.height * sizeof(Texel)});
}

void receive_colours(comm::Communicator& ranks, const io::ShapeLibrary& library, io::Job& job) {
  const std::string masters = receive_text(ranks);
  if (masters == hex(0)) return;
  std::istringstream size(receive_text(ranks));
  int width = 0, height = 0;
  std::string px_per_texel;
  size >> width >> height >> px_per_texel;
  const comm::Bytes bytes = ranks.broadcast({});
  Grid<Texel> finest(width, height);
  if (bytes.size() != finest.data().size() * sizeof(Texel)) throw std::logic_error("colours of another size");
  std::memcpy(finest.data().data(), bytes.data(), bytes.size());
  io::set_colours(std::make_shared<const ColourTarget>(finest, std::strtof(px_per_texel.c_str(), nullptr)), library, job);
  if (hex(job.colour_digest) == masters) return;
  throw InputError(library.path() + ": other colours of the drawings than in the master's library of this name; all "
                   "ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

}  // namespace tessera::cli
