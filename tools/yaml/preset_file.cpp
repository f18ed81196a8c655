#include "tools/yaml/preset_file.h"

#include "lasius/base/error.h"

namespace lasius::tool {

void try_setting(Params& params, const std::string& name, const std::string& value,
                 const Node& place) {
  try {
    const Algorithm& algorithm = find_algorithm(params.algorithm());
    if (name != "rho" && !algorithm.has(name)) {  // which is refused with both its meanings
      Params other;  // knows the names of all, and the nearest to one that none has
      set_parameter(other, name, value);
      place.fail("is no parameter of " + params.algorithm(),
                 "`lasius algorithms " + params.algorithm() + "` lists them");
    }
    set_parameter(params, name, value);
  } catch (const Error& fault) {
    if (fault.code() == ErrorCode::file_broken) throw;
    place.fail("is refused: " + fault.problem(), fault.remedy());
  }
}

void refuse_both_words(const Node& set) {
  const Node* const lost = set.find("evaporation");
  if (lost != nullptr && set.find("persistence") != nullptr)
    lost->fail("is given beside \"persistence\", which is 1 less it", "keep one of them");
}

Params known_params(const std::string& algorithm, Preset preset, const Node& place) {
  try {
    return Params(algorithm, preset);
  } catch (const Error& fault) {
    place.fail("is refused: " + fault.problem(), fault.remedy());
  }
}

PresetFile read_preset_file(const std::string& file) {
  const Node root = read_document(file, "a preset");
  root.allow({"algorithm", "preset", "set"});
  PresetFile preset{.algorithm = root.at("algorithm").text()};
  const Node* const over = root.find("preset");
  if (over != nullptr) preset.preset = static_cast<Preset>(over->choice(kPresetNames));
  Params params =
      known_params(preset.algorithm, preset.preset, over != nullptr ? *over : root.at("algorithm"));
  const Node* const set = root.find("set");
  if (set != nullptr) {
    refuse_both_words(*set);
    for (const auto& [name, value] : set->entries()) {
      preset.settings.emplace_back(name, value.text());
      try_setting(params, name, value.text(), value);
    }
  }
  try {
    validate(params);
  } catch (const Error& fault) {
    (set != nullptr ? *set : root).fail("does not go together: " + fault.problem(), fault.remedy());
  }
  return preset;
}

}  // namespace lasius::tool
