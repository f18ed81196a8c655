// Long lists made short for a page.
#pragma once

#include <cstddef>

namespace lasius::tool {

/// Every so-many-th of a list, and the last.
template <class List>
List thinned(const List& list, std::size_t stride) {
  if (list.empty()) return list;
  List kept;
  for (std::size_t i = 0; i < list.size(); i += stride) kept.push_back(list[i]);
  if ((list.size() - 1) % stride != 0) kept.push_back(list.back());
  return kept;
}

}  // namespace lasius::tool
