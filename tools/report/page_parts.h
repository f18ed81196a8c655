// The page's own text, from tools/report/page, put into the program by
// tools/cmake/LasiusPage.cmake.
#pragma once

#include <string_view>

namespace lasius::tool {

extern const std::string_view kPageStyle;   ///< style.css
extern const std::string_view kPageScript;  ///< the modules, one after another, as one

}  // namespace lasius::tool
