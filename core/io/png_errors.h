// How libpng tells that a call failed: by longjmp.
#pragma once

#include <png.h>

#include <csetjmp>
#include <cstdio>

namespace lasius {

/// What png_create_read_struct and png_create_write_struct take: this as the error pointer, and the
/// two functions. Each call into libpng is then made through `succeeds`, from frames without
/// destructors, and callbacks let no exception out.
class PngErrors {
 public:
  [[noreturn]] static void on_error(png_structp png, png_const_charp message) {
    auto* self = static_cast<PngErrors*>(png_get_error_ptr(png));
    std::snprintf(self->message_, sizeof self->message_, "%s", message);
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}

  /// False where the call failed; `message` says why.
  template <typename Call>
  bool succeeds(png_structp png, Call call) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    call();
    return true;
  }
  const char* message() const noexcept { return message_; }

 private:
  char message_[200] = {};
};

}  // namespace lasius
