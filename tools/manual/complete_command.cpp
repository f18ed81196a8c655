#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/manual/completion.h"
#include "tools/options/commands.h"

namespace lasius::tool {

// What the scripts in shells/ read: "WORD<tab>MEANING", ":files<tab>ENDING ENDING...", ":folders".
int run_command(const CompleteCommand& command) {
  const Completion completion = complete(command.manual, command.words);
  std::string text;
  for (const auto& [word, meaning] : completion.candidates) text += word + "\t" + meaning + "\n";
  if (completion.files) {
    text += ":files\t";
    for (const auto& ending : completion.endings) text += ending + " ";
    text += "\n";
  }
  if (completion.folders) text += ":folders\t\n";
  print(text);
  return kFound;
}

}  // namespace lasius::tool
