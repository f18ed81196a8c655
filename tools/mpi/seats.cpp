#include "tools/mpi/seats.h"

#include <mpi.h>

#include <array>
#include <cstdlib>
#include <cstring>

#include "tools/console/values.h"
#include "tools/mpi/letters.h"

namespace lasius::tool {

std::string Seats::told() {
  std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
  int length = 0;
  MPI_Get_processor_name(name.data(), &length);
  cpu_set_t cores;
  CPU_ZERO(&cores);
  sched_getaffinity(0, sizeof(cores), &cores);  // none where there are more than it holds
  std::string text;
  put(text, std::string(name.data(), static_cast<std::size_t>(length)));
  put(text, std::string(reinterpret_cast<const char*>(&cores), sizeof(cores)));
  return text;
}

void Seats::learn(int rank, std::string_view told) {
  Rank& one = ranks_[rank];
  one.host = &hosts_[take_text(told)];
  const std::string mask = take_text(told);
  std::memcpy(&one.cores, mask.data(), sizeof(one.cores));
}

void Seats::read_environment() {
  const char* const asked = std::getenv("LASIUS_MPI_CORES");
  if (asked != nullptr && *asked != '\0')
    asked_ = static_cast<int>(integer_value("LASIUS_MPI_CORES", asked, 1, 1 << 20));
}

void Seats::clear() {
  for (auto& [name, host] : hosts_) host = {};
  for (auto& [number, rank] : ranks_) rank.sits = false;
}

bool Seats::take(int rank) {
  Rank& taker = ranks_.at(rank);
  Host& host = *taker.host;
  if (asked_ > 0 && host.seated >= asked_) return false;
  if (asked_ == 0 && CPU_COUNT(&taker.cores) > 0) {
    int core = 0;
    while (core < CPU_SETSIZE && (!CPU_ISSET(core, &taker.cores) || CPU_ISSET(core, &host.taken)))
      ++core;
    if (core == CPU_SETSIZE) return false;
    CPU_SET(core, &host.taken);
    taker.core = core;
  }
  ++host.seated;
  return taker.sits = true;
}

void Seats::leave(int rank) {
  Rank& leaver = ranks_.at(rank);
  if (!leaver.sits) return;
  CPU_CLR(leaver.core, &leaver.host->taken);
  --leaver.host->seated;
  leaver.sits = false;
}

}  // namespace lasius::tool
