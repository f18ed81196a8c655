#include "tools/record/outputs.h"

#include <algorithm>

#include "core/base/output.h"
#include "lasius/base/error.h"
#include "tools/console/crew.h"
#include "tools/console/streams.h"

namespace lasius::tool {

bool is_picture(std::string_view file) {
  return has_ending(file, ".svg") || has_ending(file, ".png");
}

bool is_table(std::string_view file) { return has_ending(file, ".csv"); }

bool is_yaml(std::string_view file) {
  return has_ending(file, ".yaml") || has_ending(file, ".yml");
}

bool is_film(std::string_view file) { return has_ending(file, ".gif"); }

bool is_page(std::string_view file) { return has_ending(file, ".html"); }

bool is_proof(std::string_view file) {
  return has_ending(file, ".proof.json") || has_ending(file, ".proof.cbor");
}

void check_files(const SearchOptions& options) {
  if (!follows()) check_outputs(options.outputs, options.inputs);
}

void write_output(const std::string& file, const Forms& forms) {
  if (is_picture(file)) return forms.picture(file);
  if (is_proof(file) && !forms.proof)
    return message(file + " is not written: there is no path, and nothing is proven");
  const auto proof = [&](std::ostream& out) { forms.proof(out, has_ending(file, ".cbor")); };
  write_file(file, is_table(file)                ? forms.csv
                   : is_yaml(file) && forms.yaml ? forms.yaml
                   : is_film(file) && forms.film ? forms.film
                   : is_page(file) && forms.page ? forms.page
                   : is_proof(file)              ? proof
                                                 : forms.json);
}

Delivery::Delivery(const std::vector<std::string>& files) {
  if (follows()) return;
  left_ = files;
  const auto quick = [](const std::string& file) {
    return !is_picture(file) && !is_film(file) && !is_page(file) && !is_proof(file);
  };
  if (std::ranges::none_of(left_, is_stream))
    std::stable_partition(left_.begin(), left_.end(), quick);
  name_left();
}

void Delivery::name_left() {
  std::string names;
  for (const auto& file : left_) names += (names.empty() ? "" : ", ") + file;
  unwritten_.change(names.empty() ? names : "interrupted: not written: " + names);
}

void Delivery::print(const std::string& text) {
  if (closed_) return;
  try {
    tool::print(text);
  } catch (const ClosedOutput&) {
    if (left_.empty()) throw;
    closed_ = true;
  } catch (const Error&) {
    if (left_.empty()) throw;
    closed_ = true;
    fault_ = std::current_exception();
  }
}

void Delivery::write(const std::function<void(const std::string& file)>& write, bool verbose) {
  while (!left_.empty()) {
    const std::string file = left_.front();
    std::string said = verbose ? "wrote " + file : "";
    try {
      write(file);
    } catch (const Error& error) {
      said = fault_ ? error.what() : "";
      if (!fault_) fault_ = std::current_exception();
    }
    left_.erase(left_.begin());
    name_left();
    if (!said.empty()) message(said);
  }
  if (fault_) std::rethrow_exception(fault_);
}

}  // namespace lasius::tool
