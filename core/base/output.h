// Files that are either written whole or not at all, and the endings of their names.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/export.h"

namespace lasius {

/// Calls `write` with a binary stream to a temporary file, which then takes the place of `path`
/// with the permissions, and where that is allowed the owner, of the file that was there: a reader
/// never sees half a file, and a failure leaves an older file as it was. A symbolic link is
/// followed, to a file that need not exist; a stream (`is_stream`) is written to as it comes.
/// Numbers are written as in the C locale.
/// @throws Error(output_failed) where the file cannot be made, written or replaced, and whatever
///         `write` throws; nothing is left of the temporary file in either case.
LASIUS_EXPORT void write_file(const std::string& path,
                              const std::function<void(std::ostream&)>& write);

/// Refuses outputs before any work, and writes nothing.
/// @throws Error(output_failed) for one that `write_file` could not write: a folder, a file or in a
///         folder that may not be written, a name that is too long. Error(invalid_parameter) for
///         one that is an input or would be written twice, links followed, standard output among
///         them.
LASIUS_EXPORT void check_outputs(const std::vector<std::string>& outputs,
                                 const std::vector<std::string>& inputs);

/// True for what is not replaced but written to as it comes, whatever its name ends in: a device, a
/// pipe, an open file of this process (/dev/stdout, /dev/fd/3).
LASIUS_EXPORT bool is_stream(const std::string& path);

/// Removes the temporary files of this process. Whoever begins or completes a file from then on
/// waits for ever: for signal handlers that end the program, where it may be called.
LASIUS_EXPORT void abandon_outputs() noexcept;

/// True where a file's name ends in `ending`, which is in small letters, as in ".png"; capitals
/// count as small ones.
LASIUS_EXPORT bool has_ending(std::string_view path, std::string_view ending) noexcept;

}  // namespace lasius
