// Reads a result of `lasius plan --json` as a user of the library does, and prints its parameters.
#include <iostream>
#include <iterator>
#include <string>

#include "lasius/base/error.h"
#include "lasius/io/json.h"

int main() {
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  try {
    std::cout << lasius::params_to_json(lasius::params_from_json(text));
  } catch (const lasius::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
