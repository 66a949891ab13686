#include "serve/service.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "report/result_page.h"
#include "result/folder/result_file.h"
#include "result/folder/result_manifest.h"
#include "result/marks_file.h"
#include "terminal/exit_codes.h"
#include "text/utf8_text.h"

namespace tessera::serve {
namespace {

constexpr const char* kMarksName = "marks.json";

std::string page_html(const Page& page) {
  std::string html;
  write_page(page, [&](std::string_view part) { html += part; });
  return html;
}

/// A folder as an argument: not as an option.
std::string as_argument(const std::string& folder) { return folder.starts_with('-') ? "./" + folder : folder; }

std::string comma_list(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number);
  return text;
}

/// The arguments of tessera refine. Marks are saved in the new result's folder, so that the command can be repeated.
std::vector<std::string> refine_arguments(const RefineRequest& request, const std::string& from,
                                          const std::string& folder) {
  std::vector<std::string> arguments = {as_argument(from), "--out", as_argument(folder)};
  if (request.relaxes) {
    arguments.push_back("--relax");
    if (!request.marks.locked.empty()) arguments.push_back("--lock=" + comma_list(request.marks.locked));
  } else {
    const std::string marks = path_in_result(folder, kMarksName);
    write_file_atomically(marks, marks_text(request.marks, read_manifest(from).pieces_digest));
    arguments.insert(arguments.end(), {"--marks", as_argument(marks)});
  }
  if (request.seed) arguments.insert(arguments.end(), {"--set", "seed=" + std::to_string(*request.seed)});
  return arguments;
}

bool is_done(int exit_code) { return exit_code == kDoneExitCode || exit_code == kIncompleteExitCode; }

}  // namespace

Service::Service(const std::string& folder, std::size_t picture_bytes, std::function<void(const std::string&)> tell)
    : picture_bytes_(picture_bytes),
      tell_(std::move(tell)),
      results_(folder) {
  const Page page = result_page(folder, {.picture_bytes = picture_bytes_, .served = true});
  for (const std::string& warning : page.warnings) tell_(warning);
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
  look_after_refinement();
  const std::lock_guard lock(mutex_);
  nlohmann::json list = nlohmann::json::array();
  for (const ServedResult& result : results_.all()) {
    const bool runs = refinement_ && result.name == refined_;
    const auto failure = failures_.find(result.name);
    const std::string message = runs                         ? refinement_->state().last_line
                                : failure != failures_.end() ? failure->second
                                                             : "";
    const bool has_pieces = is_in_result(result.folder, kManifestName);
    list.push_back({{"name", result.name},
                    {"state", runs              ? "running"
                              : result.finished ? "finished"
                                                : "failed"},
                    {"has_pieces", has_pieces},
                    {"has_picture", !runs && has_pieces && is_in_result(result.folder, "collage.png")},
                    {"message", printable_utf8(message)},
                    {"from", result.from}});
  }
  return {.body = nlohmann::json{{"results", list}}.dump()};
}

HttpAnswer Service::data(const std::string& name) {
  std::string folder;
  {
    const std::lock_guard lock(mutex_);
    folder = results_.named(name).folder;
  }
  return {.body = page_json(result_page(folder, {.picture_bytes = picture_bytes_, .served = true}))};
}

HttpAnswer Service::refine(const RefineRequest& request) {
  look_after_refinement();
  const std::lock_guard lock(mutex_);
  if (closes_) return error_answer(409, "tessera serve is about to end");
  if (refinement_) return error_answer(409, "a refinement is at work already: " + refined_);
  const ServedResult from = results_.named(request.result);
  const ServedResult& result = results_.add(from.name);
  refinement_ = std::make_unique<Refinement>(refine_arguments(request, from.folder, result.folder));
  refined_ = result.name;
  tell_("refining " + from.folder + ": " + result.folder);
  return {.status = 202, .body = nlohmann::json{{"name", result.name}}.dump()};
}

void Service::look_after_refinement() {
  const std::lock_guard lock(mutex_);
  if (!refinement_) return;
  const Refinement::State end = refinement_->state();
  if (end.runs) return;
  note_end(end);
  refinement_.reset();
}

void Service::note_end(const Refinement::State& end) {
  const std::string& folder = results_.named(refined_).folder;
  if (is_done(end.exit_code)) {
    results_.set_finished(refined_);
    tell_("finished: " + folder);
    return;
  }
  failures_[refined_] = end.last_line.empty() ? "exit code " + std::to_string(end.exit_code) : end.last_line;
  tell_(folder + ": " + failures_[refined_]);
}

HttpAnswer Service::stop() {
  const std::lock_guard lock(mutex_);
  if (refinement_) refinement_->stop();
  return {.body = "{}"};
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
