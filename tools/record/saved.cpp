#include "tools/record/saved.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "core/base/json_place.h"
#include "tools/record/queries.h"

namespace lasius::tool {

std::string nth_result(const std::string& file, std::size_t i) {
  return file + ", result " + std::to_string(i + 1);
}

std::vector<Saved> read_results(const std::string& file) {
  auto stream = opened(file, "name a saved result");
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const std::string_view text = bytes;
  std::vector<Saved> results;
  const auto next = [&](std::size_t from) {
    return std::min(text.find_first_not_of(" \t\r\n", from), text.size());
  };
  for (std::size_t from = next(0); from < text.size();) {
    const std::size_t end = from + JsonPlace::end_of_first(text.substr(from));
    const std::size_t after = next(end);
    const bool only = results.empty() && after == text.size();
    results.push_back(
        {json::read(text.substr(0, end), only ? file : nth_result(file, results.size()), from),
         static_cast<std::int64_t>(from)});
    from = after;
  }
  return results;
}

}  // namespace lasius::tool
