#include "tools/record/outputs.h"

#include <ostream>

#include "core/base/output.h"
#include "lasius/error.h"
#include "tools/bitmap/picture.h"
#include "tools/console/streams.h"

namespace lasius::tool {
namespace {

void write(const Forms& forms, const std::string& file) {
  if (is_picture(file)) return forms.write_picture(file);
  const auto& form = has_ending(file, ".csv") ? forms.csv : forms.json;
  write_file(file, [&](std::ostream& out) { out << form(); });
}

}  // namespace

void report(const Outcome& outcome, const Messages& messages) {
  const std::string why = explain(outcome);
  if (!why.empty() && (!outcome.has_path || !messages.quiet)) message(why);
}

void deliver(const Forms& forms, bool json, const std::vector<std::string>& files,
             const Messages& messages) {
  Delivery delivery(files);
  try {
    delivery.print(json ? forms.json() : forms.text());
  } catch (const ClosedOutput&) {
    return;  // the exit code still says how the run ended
  }
  delivery.write([&](const std::string& file) {
    write(forms, file);
    if (messages.verbose) message("wrote " + file);
  });
}

void Delivery::print(const std::string& text) {
  if (closed_) return;
  try {
    tool::print(text);
  } catch (const ClosedOutput&) {
    if (files_.empty()) throw;
    closed_ = true;
  } catch (const Error&) {
    if (files_.empty()) throw;
    closed_ = true;
    fault_ = std::current_exception();
  }
}

void Delivery::write(const std::function<void(const std::string& file)>& write) {
  for (const auto& file : files_) {
    try {
      write(file);
    } catch (const Error& error) {
      if (fault_)
        message(error.what());
      else
        fault_ = std::current_exception();
    }
  }
  if (fault_) std::rethrow_exception(fault_);
}

}  // namespace lasius::tool
