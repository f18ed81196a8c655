#include "tools/mpi/seats.h"

#include <mpi.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>

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
  Host& host = hosts_[take_text(told)];
  const std::string mask = take_text(told);
  cpu_set_t cores;
  std::memcpy(&cores, mask.data(), sizeof(cores));
  CPU_OR(&host.cores, &host.cores, &cores);
  ranks_[rank].host = &host;
}

void Seats::clear() {
  const char* const asked = std::getenv("LASIUS_MPI_CORES");
  if (asked != nullptr)
    asked_ = static_cast<int>(integer_value("LASIUS_MPI_CORES", asked, 1, 1 << 20));
  for (auto& [name, host] : hosts_) host.taken = 0;
  for (auto& [number, rank] : ranks_) rank.sits = false;
}

bool Seats::take(int rank) {
  Rank& taker = ranks_.at(rank);
  const int cores = CPU_COUNT(&taker.host->cores);
  const int seats = asked_ > 0 ? asked_ : cores > 0 ? cores : std::numeric_limits<int>::max();
  if (taker.host->taken >= seats) return false;
  ++taker.host->taken;
  return taker.sits = true;
}

void Seats::leave(int rank) {
  Rank& leaver = ranks_.at(rank);
  if (leaver.sits) --leaver.host->taken;
  leaver.sits = false;
}

}  // namespace lasius::tool
