#pragma once

namespace demens::ensemble {

//! `0.1.0`
extern char const* const program_version;
//! Commit of the source the program was built from, with `-dirty` when it was changed since; "unknown"
//! outside git.
extern char const* const git_commit;

} // namespace demens::ensemble
