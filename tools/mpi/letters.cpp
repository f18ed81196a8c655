#include "tools/mpi/letters.h"

#include <cstring>
#include <thread>

namespace lasius::tool {
namespace {

/// Of a message's text; a longer one goes in several pieces, since MPI counts by int.
constexpr std::size_t kPiece = 1 << 16;

}  // namespace

void put(std::string& to, std::int64_t number) {
  to.append(reinterpret_cast<const char*>(&number), sizeof number);
}
std::int64_t take_number(std::string_view& from) {
  std::int64_t number = 0;
  std::memcpy(&number, from.data(), sizeof number);
  from.remove_prefix(sizeof number);
  return number;
}

void put(std::string& to, const std::string& text) {
  put(to, static_cast<std::int64_t>(text.size()));
  to += text;
}
std::string take_text(std::string_view& from) {
  const auto size = static_cast<std::size_t>(take_number(from));
  std::string text(from.substr(0, size));
  from.remove_prefix(size);
  return text;
}

Sending::Sending(int to, const std::string& text) {
  put(whole_, text);
  for (std::size_t at = 0; at < whole_.size(); at += kPiece)
    MPI_Isend(whole_.data() + at, static_cast<int>(std::min(kPiece, whole_.size() - at)), MPI_CHAR,
              to, 0, MPI_COMM_WORLD, &pieces_.emplace_back(MPI_REQUEST_NULL));
}

bool Sending::done() {
  int all = 0;
  MPI_Testall(static_cast<int>(pieces_.size()), pieces_.data(), &all, MPI_STATUSES_IGNORE);
  return all != 0;
}

void send(int to, const std::string& text) {
  Sending sending(to, text);
  for (Naps naps; !sending.done();) std::this_thread::sleep_for(naps.next());
}

std::optional<Letter> post() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  const int from = status.MPI_SOURCE;
  std::string text, piece(kPiece, '\0');
  std::size_t size = 0;
  do {
    MPI_Recv(piece.data(), static_cast<int>(kPiece), MPI_CHAR, from, 0, MPI_COMM_WORLD, &status);
    int count = 0;
    MPI_Get_count(&status, MPI_CHAR, &count);
    std::string_view got(piece.data(), static_cast<std::size_t>(count));
    if (size == 0) size = sizeof(std::int64_t) + static_cast<std::size_t>(take_number(got));
    text.append(piece, 0, static_cast<std::size_t>(count));
  } while (text.size() < size);
  return Letter{from, text.substr(sizeof(std::int64_t))};
}

}  // namespace lasius::tool
