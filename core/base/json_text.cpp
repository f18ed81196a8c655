#include "core/base/json_text.h"

#include "core/base/json_place.h"

namespace lasius {

nlohmann::json read_json(std::string_view text, const std::string& file) {
  return JsonPlace::parse<nlohmann::json>(text, file);
}

std::int64_t json_line(std::string_view text, std::string_view path) {
  return JsonPlace::line(text, path);
}

std::string json_text(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace lasius
