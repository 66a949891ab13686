// Answers the page of a served result: what it shows, and refinements.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "serve/http.h"
#include "serve/refine_request.h"
#include "serve/refinement.h"
#include "serve/served_results.h"

namespace tessera::serve {

class Service {
 public:
  /// Reads the result and makes its page. `picture_bytes`: the most for the tiles of a page. `tell` is called with lines
  /// for the user's terminal. Throws InputError and EnvironmentError.
  Service(const std::string& folder, std::size_t picture_bytes, std::function<void(const std::string&)> tell);

  /// The answer to a request that is not refused; `path` is that below the token (web/src/data.ts). May be called from
  /// several threads.
  HttpAnswer answer(const HttpRequest& request, const std::string& path);

  /// Notes how a refinement has ended; to be called from time to time.
  void look_after_refinement();
  /// Begins no further refinement, and stops the running one; again: at once.
  void close();
  bool refines();

 private:
  HttpAnswer state();
  HttpAnswer data(const std::string& name);
  HttpAnswer refine(const RefineRequest& request);
  HttpAnswer stop();
  void note_end(const Refinement::State& end);

  std::size_t picture_bytes_;
  std::function<void(const std::string&)> tell_;
  std::string page_;  // HTML of the first result

  std::mutex mutex_;  // of all below
  bool closes_ = false;
  ServedResults results_;
  std::unique_ptr<Refinement> refinement_;       // null: none runs
  std::string refined_;                          // the name of its result
  std::map<std::string, std::string> failures_;  // by name; what the last line was
};

}  // namespace tessera::serve
