// What there is to say of the program, as plain data: --help, `lasius help`, the man pages and the
// shells' completion are all made from it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lasius::tool {

/// What a shell may write where an option's value or an argument stands.
struct Values {
  enum class Names { none, algorithms, parameters, studies, topics };
  std::vector<std::string> choices = {};
  bool files = false;
  bool folders = false;
  std::vector<std::string> endings = {};  ///< of the files, each with its dot; empty: any
  Names names = Names::none;              ///< a list that is known at run time
  bool list = false;                      ///< several of them, parted by commas
};

struct OptionText {
  std::vector<std::string> names;  ///< "-o" and "--output"; one without dashes is an argument
  std::string value;               ///< as "FILE" or "a|b"; empty: it takes none
  /// A sentence; lines behind it that part a label from its meaning by two blanks are a list.
  std::string help;
  bool required = false;
  bool repeatable = false;
  Values values = {};

  bool is_argument() const { return names.front().front() != '-'; }
};

struct Example {
  std::string line;  ///< as typed, where maps/ is in the folder
  std::string what;
};

struct ExitText {
  int code;
  std::string meaning;
};

/// What is said of a command beside its options.
struct Notes {
  std::string detail = {};  ///< sentences behind the summary
  std::vector<Example> examples = {};
  std::vector<ExitText> exits = {};
  std::string_view json = {};  ///< heading that tells its fields: a `RESULTS` of make_manual
};

struct CommandText : Notes {
  std::string name;
  std::string summary;
  std::vector<OptionText> options;  ///< arguments first, in their order
};

struct Manual {
  std::string summary;
  std::vector<OptionText> options;  ///< of the program itself
  std::vector<CommandText> commands;
};

/// `lasius help`, and every --help.
struct HelpCommand {
  Manual manual;
  std::string topic;        ///< a topic or command; empty: the program
  bool json = false;        ///< all that there is to tell, for tools
  bool of_command = false;  ///< `topic` is a command, be there a topic of its name
};

/// `lasius complete WORD...`, which the shells ask: the words after the program's name, the last
/// one as far as it is typed.
struct CompleteCommand {
  Manual manual;
  std::vector<std::string> words;
};

}  // namespace lasius::tool
