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
#include "job/pieces/job_library.h"
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

double receive_number(comm::Communicator& ranks) { return std::strtod(receive_text(ranks).c_str(), nullptr); }

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

/// `masters`: the digest of the content.
void check_library(const ShapeLibrary& library, const std::string& masters) {
  const std::string own = hex(library.content_digest());
  if (own == masters) return;
  throw InputError(library.path() + ": another library than the master's of this name (digest of the content " + own +
                   ", the master's " + masters +
                   "); all ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

/// `masters`: the digest of what lies over the canvas, with the colours of the drawings.
void check_colours(const CollageProblem& problem, const std::string& masters) {
  if (hex(problem.job().overlay_digest) == masters) return;
  throw InputError(problem.library().path() +
                   ": other colours of the drawings than in the master's library of this name; all "
                   "ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

}  // namespace

std::string program_identity() {
  return std::string("tessera ") + program_version() + ", commit " + program_commit() + ", kernels " + kernel_digest();
}

// Each as a text of its own, the program first: programs that differ need to agree about nothing else.
void announce_job(comm::Communicator& ranks, const std::string& program, const Job& job) {
  ranks.broadcast(to_bytes(program));
  ranks.broadcast(to_bytes(to_toml(job)));
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
  return job;
}

// Of colours the finest level alone: the others follow from it.
void announce_findings(comm::Communicator& ranks, const CanvasFindings& found) {
  ranks.broadcast(to_bytes(exact_text(found.size_factor)));
  ranks.broadcast(to_bytes(exact_text(found.room_part)));
  const ColourTarget* const colour = found.overlays.colour.get();
  const int width = colour ? int(colour->levels().front().width) : 0;
  const int height = colour ? int(colour->levels().front().height) : 0;
  send_cells<Texel>(ranks, {width, height}, colour ? colour->px_per_texel() : 0,
                    colour ? colour->texels().data() : nullptr);
  const SizeMap none;
  const SizeMap& sizes = found.overlays.sizes ? *found.overlays.sizes : none;
  send_cells<float>(ranks, {sizes.part.width(), sizes.part.height()}, sizes.cells_per_px, sizes.part.data().data());
}

CanvasFindings receive_findings(comm::Communicator& ranks) {
  CanvasFindings found;
  found.size_factor = receive_number(ranks);
  found.room_part = receive_number(ranks);
  float length = 0;
  const Grid<Texel> finest = receive_cells<Texel>(ranks, length);
  if (!finest.data().empty()) found.overlays.colour = std::make_shared<const ColourTarget>(finest, length);
  SizeMap sizes;
  sizes.part = receive_cells<float>(ranks, sizes.cells_per_px);
  if (!sizes.part.data().empty()) found.overlays.sizes = std::make_shared<const SizeMap>(std::move(sizes));
  return found;
}

void announce_problem(comm::Communicator& ranks, const std::string& program, const CollageProblem& problem,
                      std::uint64_t library_digest) {
  announce_job(ranks, program, problem.job());
  ranks.broadcast(to_bytes(hex(library_digest)));
  announce_findings(ranks, problem.found());
  ranks.broadcast(to_bytes(hex(problem.job().overlay_digest)));
}

CollageProblem receive_problem(comm::Communicator& ranks, Job job) {
  LibraryView library = open_library_of(job);
  check_library(library, receive_text(ranks));
  CanvasFindings found = receive_findings(ranks);
  resolve_wishes(library, job);
  CollageProblem problem(std::move(job), std::move(library), std::move(found));
  check_colours(problem, receive_text(ranks));
  return problem;
}

}  // namespace tessera
