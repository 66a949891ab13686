// The library of a job.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"
#include "library/library_view.h"

namespace tessera {

/// Absolute paths from `library.file` or `library.files`.
std::vector<std::string> library_paths(const Job& job);

/// The paths of the library with commas between them, for messages and records.
std::string library_text(const Job& job);

/// Opens the shapes that the job chooses. Throws InputError that names the job, the key, the file, what is wrong with
/// it and what is allowed.
LibraryView open_library_of(const Job& job);

/// Texts in the job's [[shapes]] and [style] that look like patterns but are, letter by letter, names in the library's
/// files. Such a text selects only the shape of that name, and none where the job has left out that shape (NameIndex).
std::vector<std::string> names_like_patterns(const LibraryView& library, const Job& job);

/// Resolves the job's wishes by the names of the library's shapes (wish_resolution.h).
void resolve_wishes(const LibraryView& library, Job& job);

/// Adds the pieces that the job starts from (start_pieces.h); call it after resolve_wishes. Needed only where pieces
/// are placed.
void add_start_pieces(const ShapeLibrary& library, Job& job);

}  // namespace tessera
