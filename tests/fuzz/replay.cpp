// All readers without libFuzzer: replay SEEDS MUTATIONS reads every file of SEEDS/READER, and as many damaged copies of each,
// the same in every run. Ends with an error where a reader crashes, takes too long for an input, or too much memory.
#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>

#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// For one input: seconds of processor time, and the most memory that the program may have taken after it.
constexpr int kMostSeconds = 2;
constexpr long kMostKilobytes = 1 << 20;
/// Changes of one copy at most.
constexpr int kMostChanges = 8;

volatile std::sig_atomic_t currentReader = 0, currentInput = 0, currentCopy = 0;

[[noreturn]] void stop(const char* why) {
  std::fprintf(stderr, "reader %s, input %d, copy %d: %s\n", Reader::all()[std::size_t(currentReader)]->name,
               int(currentInput), int(currentCopy), why);
  std::_Exit(1);
}

void startTimer() {
  const itimerval limit{{0, 0}, {kMostSeconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

void readOne(const Reader& reader, const Bytes& bytes) {
  startTimer();
  reader.read(bytes.data(), bytes.size());
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  if (use.ru_maxrss > kMostKilobytes) stop("more than 1 GiB of memory");
}

/// Bits flipped, bytes that headers like to trip over, pieces taken out, doubled, or copied from another input.
void damage(Bytes& bytes, const Bytes& other, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : std::size_t(random()) % n; };
  const std::size_t at = below(bytes.size()), length = 1 + below(std::min<std::size_t>(bytes.size(), 64));
  const auto begin = bytes.begin() + std::ptrdiff_t(at);
  const auto end = begin + std::ptrdiff_t(std::min(length, bytes.size() - at));
  constexpr std::uint8_t kOdd[] = {0x00, 0x01, 0x7f, 0x80, 0xff, '-', '9', '[', '"'};
  switch (below(6)) {
    case 0:
      if (!bytes.empty()) *begin ^= std::uint8_t(1u << below(8));
      break;
    case 1:
      std::fill(begin, end, kOdd[below(std::size(kOdd))]);
      break;
    case 2:
      bytes.erase(begin, end);
      break;
    case 3: {
      const Bytes piece(begin, end);
      bytes.insert(begin, piece.begin(), piece.end());
      break;
    }
    case 4:
      bytes.resize(at);
      break;
    default:
      for (std::size_t i = at, from = below(other.size()); i < std::min(at + length, bytes.size());
           ++i, ++from)
        if (from < other.size()) bytes[i] = other[from];
  }
}

Bytes contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), {});
}

/// Number of inputs.
std::size_t replay(const Reader& reader, const fs::path& seeds, int copies) {
  std::vector<fs::path> paths(fs::directory_iterator(seeds / reader.name), fs::directory_iterator{});
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> inputs;
  for (const fs::path& path : paths) inputs.push_back(contentOf(path));
  std::mt19937 random(1);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    currentInput = int(i);
    currentCopy = 0;
    readOne(reader, inputs[i]);
    for (int copy = 1; copy <= copies; ++copy) {
      currentCopy = copy;
      Bytes bytes = inputs[i];
      const int changes = 1 + int(random() % kMostChanges);
      for (int change = 0; change < changes; ++change)
        damage(bytes, inputs[random() % inputs.size()], random);
      readOne(reader, bytes);
    }
  }
  return inputs.size();
}

}  // namespace
}  // namespace quell::fuzz

int main(int argc, char** argv) {
  using namespace quell::fuzz;
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s SEEDS COPIES\n", argv[0]);
    return 2;
  }
  std::signal(SIGPROF, [](int) { stop("more than 2 s"); });
  std::vector<const Reader*>& readers = Reader::all();
  for (std::size_t i = 0; i < readers.size(); ++i) {
    currentReader = int(i);
    const std::clock_t begin = std::clock();
    const std::size_t inputs = replay(*readers[i], argv[1], std::atoi(argv[2]));
    std::printf("%s: %zu inputs, %.2f s\n", readers[i]->name, inputs,
                double(std::clock() - begin) / CLOCKS_PER_SEC);
    if (inputs == 0) return 1;
  }
  std::filesystem::remove_all(directoryOfFiles());
  return 0;
}
