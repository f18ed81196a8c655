#include "outputs.h"

#include <exception>
#include <ostream>

#include "lasius/error.h"
#include "lasius/output.h"
#include "picture.h"
#include "streams.h"

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
  std::exception_ptr fault;
  try {
    print(json ? forms.json() : forms.text());
  } catch (const ClosedOutput&) {
  } catch (const Error&) {
    fault = std::current_exception();
  }
  for (const auto& file : files) {
    write(forms, file);
    if (messages.verbose) message("wrote " + file);
  }
  if (fault) std::rethrow_exception(fault);
}

}  // namespace lasius::tool
