// Runs a fuzz target over files and over damaged copies of them: a fixed number of inputs from a
// fixed seed, so that a failure repeats. Coverage-guided fuzzing is what MACULA_FUZZ=ON is for.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uintmax_t kLargestFile = 256 * 1024;
constexpr int kCopiesPerFile = 24;

std::vector<Bytes> readCorpus(int argc, char** argv) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i) {
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[i], error)) {
      if (entry.is_regular_file() && entry.file_size() <= kLargestFile) files.push_back(entry);
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<Bytes> corpus{{}};  // the empty input always
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return corpus;
}

Bytes damaged(Bytes bytes, std::mt19937& random) {
  if (bytes.empty()) return {static_cast<std::uint8_t>(random())};
  switch (random() % 4) {
    case 0:  // truncated
      bytes.resize(random() % bytes.size());
      break;
    case 1:  // some bytes changed
      for (int i = 0; i < 8; ++i)
        bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
      break;
    case 2: {  // a piece repeated
      const std::size_t begin = random() % bytes.size();
      const std::size_t length = std::min<std::size_t>(bytes.size() - begin, 64);
      const Bytes piece(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                        bytes.begin() + static_cast<std::ptrdiff_t>(begin + length));
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(begin), piece.begin(), piece.end());
      break;
    }
    default:  // a digit replaced: sizes, counts and offsets live in digits
      for (auto& byte : bytes) {
        if (byte >= '0' && byte <= '9' && random() % 16 == 0) {
          byte = static_cast<std::uint8_t>('0' + random() % 10);
        }
      }
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  std::mt19937 random(1);
  std::size_t runs = 0;
  for (const Bytes& bytes : readCorpus(argc, argv)) {
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    ++runs;
    for (int i = 0; i < kCopiesPerFile; ++i, ++runs) {
      const Bytes copy = damaged(bytes, random);
      LLVMFuzzerTestOneInput(copy.data(), copy.size());
    }
  }
  std::printf("%zu inputs\n", runs);
  return 0;
}
