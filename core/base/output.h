// Files that are either written whole or not at all, and the endings of their names.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <string_view>

#include "lasius/export.h"

namespace lasius {

/// Calls `write` with a binary stream to a temporary file beside `path`, then renames that file to
/// `path`: a reader never sees half a file, and a failure leaves an older file as it was. A
/// symbolic link is followed, to a file that need not exist; a device or pipe (/dev/stdout) is
/// written directly. Numbers are written as in the C locale.
/// @throws Error(output_failed) where the file cannot be made, written or renamed, and whatever
///         `write` throws; the temporary file is removed in either case.
LASIUS_EXPORT void write_file(const std::string& path,
                              const std::function<void(std::ostream&)>& write);

/// True where a file's name ends in `ending`, which is in small letters, as in ".png"; capitals
/// count as small ones.
LASIUS_EXPORT bool has_ending(std::string_view path, std::string_view ending) noexcept;

}  // namespace lasius
