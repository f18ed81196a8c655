// Random123 refuses machines that are not on its list, and WebAssembly is not. It is compiled as for
// s390x, for which it has plain C alone.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <limits>
#include <type_traits>

#define __s390x__ 1
#include_next <Random123/philox.h>
#undef __s390x__
