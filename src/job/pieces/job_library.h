// The library that a job names.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"
#include "library/library_view.h"

namespace tessera {

/// Absolute paths: `library.file`, or `library.files`.
std::vector<std::string> library_paths(const Job& job);

/// The same for messages and records, with commas between them.
std::string library_text(const Job& job);

/// The shapes that the job chooses. Throws InputError that names the job, the key, the file, what is wrong with it and
/// what is allowed.
LibraryView open_library_of(const Job& job);

/// What the job's [[shapes]] and its [style] select shapes by and is the name of one in the library's files letter by
/// letter, though it looks like a pattern. The job may have left out that shape: then it selects no other (NameIndex).
std::vector<std::string> names_like_patterns(const LibraryView& library, const Job& job);

/// Resolves the job's wishes by the names of the library's shapes (wish_resolution.h).
void resolve_wishes(const LibraryView& library, Job& job);

/// Adds the pieces that the job starts from (start_pieces.h), after resolve_wishes. Only who places them needs them.
void add_start_pieces(const ShapeLibrary& library, Job& job);

}  // namespace tessera
