#include "run/rank_agreement.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "job/canvas/overlays.h"
#include "worker/devices/kernel_options.h"

namespace tessera {
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

struct CellCount {
  int width;
  int height;
};

/// Its size and length as a text, then its cells.
template <class Cell>
void send_cells(comm::Communicator& ranks, CellCount count, float length, const Cell* cells) {
  ranks.broadcast(
      to_bytes(std::to_string(count.width) + " " + std::to_string(count.height) + " " + exact_text(double(length))));
  const char* const bytes = reinterpret_cast<const char*>(cells);
  ranks.broadcast({bytes, bytes + std::size_t(count.width) * std::size_t(count.height) * sizeof(Cell)});
}

template <class Cell>
Grid<Cell> receive_cells(comm::Communicator& ranks, float& length) {
  std::istringstream text(receive_text(ranks));
  CellCount count{};
  std::string exact_length;
  text >> count.width >> count.height >> exact_length;
  length = std::strtof(exact_length.c_str(), nullptr);
  const comm::Bytes bytes = ranks.broadcast({});
  Grid<Cell> cells(count.width, count.height);
  if (bytes.size() != cells.data().size() * sizeof(Cell)) throw std::logic_error("cells of another size");
  if (!bytes.empty()) std::memcpy(static_cast<void*>(cells.data().data()), bytes.data(), bytes.size());
  return cells;
}

}  // namespace

std::string program_identity() {
  return std::string("tessera ") + program_version() + ", commit " + program_commit() + ", kernels " + kernel_digest();
}

// Each as a text of its own, the program first: programs that differ need to agree about nothing else.
void announce_run(comm::Communicator& ranks, const std::string& program, const Job& job, std::uint64_t library_digest) {
  ranks.broadcast(to_bytes(program));
  ranks.broadcast(to_bytes(to_toml(job)));
  ranks.broadcast(to_bytes(exact_text(job.size_factor)));
  ranks.broadcast(to_bytes(hex(library_digest)));
}

Job receive_job(comm::Communicator& ranks, const std::string& program) {
  const std::string masters_program = receive_text(ranks);
  if (program != masters_program) {
    throw EnvironmentError("this rank runs " + program + ", the master " + masters_program +
                           "; allowed: the same program on all ranks; install it anew on every node");
  }
  const std::string masters_job = receive_text(ranks);
  Job job = job_from_toml(masters_job, "the master's job");
  if (to_toml(job) != masters_job) {
    throw EnvironmentError(
        "this rank understands the master's job otherwise than the master; install the same program "
        "and the same libraries on every node");
  }
  job.size_factor = std::strtod(receive_text(ranks).c_str(), nullptr);
  return job;
}

void check_library(comm::Communicator& ranks, const ShapeLibrary& library) {
  const std::string masters = receive_text(ranks);
  const std::string own = hex(library.content_digest());
  if (own == masters) return;
  throw InputError(library.path() + ": another library than the master's of this name (digest of the content " + own +
                   ", the master's " + masters +
                   "); all ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

// Of colours the finest level alone: the others follow from it.
void announce_overlays(comm::Communicator& ranks, const Job& job) {
  ranks.broadcast(to_bytes(hex(job.overlay_digest)));
  const ColourWish& colour = job.settings.colour;
  const int width = colour.target ? int(colour.target->levels().front().width) : 0;
  const int height = colour.target ? int(colour.target->levels().front().height) : 0;
  send_cells<Texel>(ranks, {width, height}, colour.target ? colour.target->px_per_texel() : 0,
                    colour.target ? colour.target->texels().data() : nullptr);
  const SizeMap none;
  const SizeMap& sizes = job.settings.pieces.size_map ? *job.settings.pieces.size_map : none;
  send_cells<float>(ranks, {sizes.part.width(), sizes.part.height()}, sizes.cells_per_px, sizes.part.data().data());
}

void receive_overlays(comm::Communicator& ranks, const ShapeLibrary& library, Job& job) {
  const std::string masters = receive_text(ranks);
  Overlays overlays;
  float length = 0;
  const Grid<Texel> finest = receive_cells<Texel>(ranks, length);
  if (!finest.data().empty()) overlays.colour = std::make_shared<const ColourTarget>(finest, length);
  SizeMap sizes;
  sizes.part = receive_cells<float>(ranks, sizes.cells_per_px);
  if (!sizes.part.data().empty()) overlays.sizes = std::make_shared<const SizeMap>(std::move(sizes));
  set_overlays(overlays, library, job);
  if (hex(job.overlay_digest) == masters) return;
  throw InputError(library.path() +
                   ": other colours of the drawings than in the master's library of this name; all "
                   "ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

}  // namespace tessera
