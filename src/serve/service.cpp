#include "serve/service.h"

#include <unistd.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/own_program.h"
#include "report/result_page.h"
#include "result/folder/result_file.h"
#include "result/folder/result_manifest.h"
#include "terminal/exit_codes.h"
#include "terminal/shell_word.h"
#include "text/utf8_text.h"

namespace tessera::serve {
namespace {

std::string page_html(const Page& page) {
  std::string html;
  write_page(page, [&](std::string_view part) { html += part; });
  return html;
}

/// A folder as an argument: not as an option.
std::string as_argument(const std::string& folder) { return folder.starts_with('-') ? "./" + folder : folder; }

/// The file with the marks, in the new result's folder, so that the command can be given again.
std::string marks_path(const ServedResult& result) { return path_in_result(result.folder, "marks.json"); }

/// The arguments of tessera refine.
std::vector<std::string> refine_arguments(const RefineRequest& request, const ServedResult& from,
                                          const ServedResult& result) {
  std::vector<std::string> arguments = {as_argument(from.folder),        "--out",
                                        as_argument(result.folder),      "--marks",
                                        as_argument(marks_path(result)), "--early"};
  if (request.seed) arguments.insert(arguments.end(), {"--set", "seed=" + std::to_string(*request.seed)});
  return arguments;
}

std::string command_text(const std::vector<std::string>& arguments) {
  std::string text = "tessera refine";
  for (const std::string& argument : arguments) text += " " + shell_word(argument);
  return text;
}

bool is_done(int exit_code) { return exit_code == kDoneExitCode || exit_code == kIncompleteExitCode; }

/// Whether a result has a file; where nobody can tell, it has none.
bool has_file(const ServedResult& result, const char* name) {
  try {
    return is_in_result(result.folder, name);
  } catch (const EnvironmentError&) {
    return false;
  }
}

const char* state_word(const ServedResult& result, bool runs) {
  if (runs) return "running";
  if (result.finished) return "finished";
  return result.stopped ? "stopped" : "failed";
}

}  // namespace

Service::Service(const std::string& folder, std::size_t picture_bytes)
    : picture_bytes_(picture_bytes),
      program_(own_program()),
      results_(folder) {
  const Page page = result_page(folder, {.picture_bytes = picture_bytes_, .served = true});
  news_ = page.warnings;
  page_ = page_html(page);
}

HttpAnswer Service::answer(const HttpRequest& request, const std::string& path) {
  try {
    const bool posts = request.method == "POST";
    if (posts && path == "refine") return refine(parse_refine_request(request.body));
    if (posts && path == "stop") return stop();
    if (!posts && path == "") return {.type = "text/html; charset=utf-8", .body = page_};
    if (!posts && path == "state") return state();
    if (!posts && path == "data") return data(request.result);
    return error_answer(404, "there is nothing at this address");
  } catch (const InputError& error) {
    return error_answer(400, error.what());
  } catch (const EnvironmentError& error) {
    return error_answer(500, error.what());
  }
}

HttpAnswer Service::state() {
  const std::lock_guard lock(mutex_);
  note_end();
  nlohmann::json list = nlohmann::json::array();
  for (const ServedResult& result : results_.all()) {
    const bool runs = refinement_ && result.name == refined_;
    const bool has_pieces = has_file(result, kManifestName);
    list.push_back({{"name", result.name},
                    {"state", state_word(result, runs)},
                    {"has_pieces", has_pieces},
                    {"has_picture", !runs && has_pieces && has_file(result, "collage.png")},
                    {"message", printable_utf8(runs ? refinement_->state().last_line : result.message)},
                    {"from", result.from}});
  }
  return {.body = nlohmann::json{{"results", list}}.dump()};
}

HttpAnswer Service::data(const std::string& name) {
  const std::lock_guard one_at_a_time(making_page_);
  std::string folder;
  {
    const std::lock_guard lock(mutex_);
    if (closes_) return error_answer(503, "tessera serve is about to end");
    folder = results_.named(name).folder;
  }
  return {.body = page_json(result_page(folder, {.picture_bytes = picture_bytes_, .served = true}))};
}

HttpAnswer Service::refine(const RefineRequest& request) {
  const std::lock_guard lock(mutex_);
  note_end();
  if (closes_) return error_answer(409, "tessera serve is about to end");
  if (refinement_) return error_answer(409, "a refinement is at work already: " + refined_);
  const ServedResult from = results_.named(request.result);
  if (read_manifest(from.folder).pieces_digest != request.pieces_digest) {
    return error_answer(409, from.name + " has other pieces by now; load the page again");
  }
  const ServedResult& result = results_.add(from.name);
  try {
    start(request, from, result);
  } catch (...) {
    ::unlink(marks_path(result).c_str());
    results_.remove_last();
    throw;
  }
  refined_ = result.name;
  return {.status = 202, .body = nlohmann::json{{"name", refined_}}.dump()};
}

void Service::start(const RefineRequest& request, const ServedResult& from, const ServedResult& result) {
  write_file_atomically(marks_path(result), marks_text(request.marks, request.pieces_digest));
  const std::vector<std::string> arguments = refine_arguments(request, from, result);
  refinement_ = std::make_unique<Refinement>(program_, arguments);
  command_ = command_text(arguments);
  news_.push_back(command_);
}

HttpAnswer Service::stop() {
  const std::lock_guard lock(mutex_);
  if (refinement_) refinement_->stop();
  return {.body = "{}"};
}

/// Looks whether the refinement has ended, and how.
void Service::note_end() {
  if (!refinement_) return;
  const Refinement::State end = refinement_->state();
  if (end.runs) return;
  ServedResult& result = results_.named(refined_);
  result.finished = is_done(end.exit_code);
  result.stopped = end.exit_code == kUnfinishedExitCode;
  if (result.stopped) {
    result.message = command_ + " --resume=auto goes on";
  } else if (!result.finished) {
    result.message = end.last_line.empty() ? "exit code " + std::to_string(end.exit_code) : end.last_line;
  }
  const std::string how = result.finished ? "finished" : (result.stopped ? "stopped; " : "") + result.message;
  news_.push_back(result.folder + ": " + how);
  refinement_.reset();
}

std::vector<std::string> Service::news() {
  const std::lock_guard lock(mutex_);
  note_end();
  return std::exchange(news_, {});
}

void Service::close() {
  const std::lock_guard lock(mutex_);
  closes_ = true;
  if (refinement_) refinement_->stop();
}

bool Service::refines() {
  const std::lock_guard lock(mutex_);
  return refinement_ != nullptr;
}

}  // namespace tessera::serve
