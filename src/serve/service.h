// Answers the page of a served result: what it shows, and refinements.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "serve/http.h"
#include "serve/refine_request.h"
#include "serve/refinement.h"
#include "serve/served_results.h"

namespace tessera::serve {

class Service {
 public:
  /// Reads the result and makes its page. `picture_bytes`: the most for the tiles of a page. Throws InputError and
  /// EnvironmentError.
  Service(const std::string& folder, std::size_t picture_bytes);

  /// The answer to a request that is not refused; `path` is that below the token (web/src/data.ts). May be called from
  /// several threads.
  HttpAnswer answer(const HttpRequest& request, const std::string& path);

  /// Returns the lines that have come up for the user's terminal since the last call. To be called from time to time.
  std::vector<std::string> news();
  /// Begins no further refinement, and stops the one that runs. A second call stops it at once.
  void close();
  bool refines();

 private:
  HttpAnswer state();
  HttpAnswer data(const std::string& name);
  HttpAnswer refine(const RefineRequest& request);
  HttpAnswer stop();
  void start(const RefineRequest& request, const ServedResult& from, const ServedResult& result);
  void note_end();

  std::size_t picture_bytes_;
  std::string program_;
  std::string page_;  // HTML of the first result

  std::mutex making_page_;  // one at a time: each takes much memory

  std::mutex mutex_;  // of all below; never held while something is printed
  bool closes_ = false;
  ServedResults results_;
  std::unique_ptr<Refinement> refinement_;  // null: none runs
  std::string refined_;                     // the name of its result
  std::string command_;                     // that the user can give, too
  std::vector<std::string> news_;
};

}  // namespace tessera::serve
