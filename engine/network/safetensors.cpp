#include "engine/network/safetensors.h"

#include <algorithm>
#include <bit>
#include <glm/gtc/packing.hpp>
#include <set>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/settings/typed_reader.h"

namespace macula::network {
namespace {

using nlohmann::json;
using settings::shownText;
using settings::TypedReader;

/// Bytes before the header: its length.
constexpr std::size_t kLengthBytes = 8;
/// Bytes of a header at most. 16 tensors and 64 features take some 10 KB; this bounds what the JSON
/// of a damaged file takes in memory.
constexpr std::size_t kMaxHeaderBytes = 64U << 10U;
/// A header is an object of objects with lists.
constexpr int kMaxDepth = 3;

std::uint64_t littleEndian(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    value |= std::to_integer<std::uint64_t>(bytes[i]) << (8U * i);
  }
  return value;
}

/// The header's bytes.
std::string_view headerOf(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() < kLengthBytes) {
    failInput("{}: byte 0: the file has {}, too few for a safetensors file; {}", name,
              counted(bytes.size(), "byte"), kExportAgain);
  }
  const std::uint64_t length = littleEndian(bytes.first(kLengthBytes));
  if (length > bytes.size() - kLengthBytes) {
    failInput(
        "{}: byte 0: the header is said to have {} bytes, {} follow; this is no safetensors file "
        "or it is cut short, {}",
        name, length, bytes.size() - kLengthBytes, kExportAgain);
  }
  if (length > kMaxHeaderBytes) {
    failInput("{}: byte 0: the header has {} bytes, the limit is {}; shorten its texts", name,
              length, kMaxHeaderBytes);
  }
  return {reinterpret_cast<const char*>(bytes.data()) + kLengthBytes, length};
}

/// Refuses what the JSON library accepts: duplicate keys and unlimited depth.
class HeaderGuard {
 public:
  explicit HeaderGuard(const std::string& name) : name_(&name) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    using Event = json::parse_event_t;
    if (event == Event::object_start || event == Event::array_start) {
      if (depth >= kMaxDepth) {
        failInput("{}: header: is nested too deep; {}", *name_, kExportAgain);
      }
      if (event == Event::object_start) keys_[depth].clear();
    } else if (event == Event::key) {
      // The depth of a key is that of its value.
      const auto& key = parsed.get_ref<const std::string&>();
      if (!keys_[depth - 1].insert(key).second) {
        failInput("{}: header: '{}' stands there twice; {}", *name_, shownText(key), kExportAgain);
      }
    }
    return true;
  }

 private:
  const std::string* name_;
  std::set<std::string> keys_[kMaxDepth];
};

json parseHeader(std::string_view text, const std::string& name) {
  // The format wants the brace first, so that such a file is told from others by its ninth byte.
  if (text.empty() || text.front() != '{') {
    failInput("{}: byte {}: no JSON object begins here, so this is no safetensors file; {}", name,
              kLengthBytes, kExportAgain);
  }
  // The JSON library takes a NUL for the end of its input and would not see what follows.
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    failInput("{}: byte {}: the header is no JSON; {}", name, kLengthBytes + nul, kExportAgain);
  }
  try {
    HeaderGuard guard(name);
    return json::parse(text, std::ref(guard));
  } catch (const json::parse_error& error) {
    failInput("{}: byte {}: the header is no JSON; {}", name, kLengthBytes + error.byte - 1,
              kExportAgain);
  } catch (const json::exception&) {
    failInput("{}: header: holds a number that is too large; {}", name, kExportAgain);
  }
}

/// A list of whole numbers of a tensor.
std::vector<std::size_t> wholeNumbers(TypedReader& tensor, const char* key) {
  const auto numbers = tensor.get<std::vector<std::int64_t>>(key, {.min = 0});
  return {numbers.begin(), numbers.end()};
}

constexpr std::size_t bytesOf(ScalarType type) {
  return type == ScalarType::F32 ? 4 : 2;
}

/// Whether a tensor of this shape takes `bytes`; products that would overflow do not.
bool fills(const std::vector<std::size_t>& shape, ScalarType type, std::size_t bytes) {
  if (std::find(shape.begin(), shape.end(), 0U) != shape.end()) return bytes == 0;
  std::size_t product = bytesOf(type);
  for (const std::size_t side : shape) {
    if (product > bytes / side) return false;
    product *= side;
  }
  return product == bytes;
}

/// Where a tensor lies among the data.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string place;
};

Tensor tensorOf(const json& value, std::span<const std::byte> data, Range& range) {
  if (!value.is_object()) failInput("{}: is no object; {}", range.place, kExportAgain);
  TypedReader reader(settings::DataNode(value), range.place, kExportAgain);
  Tensor tensor;
  tensor.type = static_cast<ScalarType>(reader.getChoice("dtype", {"F16", "F32"}));
  tensor.shape = wholeNumbers(reader, "shape");
  const std::vector<std::size_t> offsets = wholeNumbers(reader, "data_offsets");
  reader.finish();
  if (offsets.size() != 2 || offsets[0] > offsets[1]) {
    failInput("{}: 'data_offsets' is no beginning and end; {}", range.place, kExportAgain);
  }
  range.begin = offsets[0];
  range.end = offsets[1];
  if (range.end > data.size()) {
    failInput("{}: ends at byte {} of the data, which has {}; the file is cut short or damaged, {}",
              range.place, range.end, data.size(), kExportAgain);
  }
  tensor.bytes = data.subspan(range.begin, range.end - range.begin);
  if (!fills(tensor.shape, tensor.type, tensor.bytes.size())) {
    failInput("{}: has {}, which its shape does not fill; {}", range.place,
              counted(tensor.bytes.size(), "byte"), kExportAgain);
  }
  return tensor;
}

/// Every byte belongs to exactly one tensor.
void checkRanges(std::vector<Range> ranges, std::size_t dataBytes, const std::string& name) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
  });
  std::size_t end = 0;
  for (const Range& range : ranges) {
    if (range.begin != end) {
      failInput("{}: begins at byte {} of the data, the tensor before it ends at {} ({}); {}",
                range.place, range.begin, end, range.begin < end ? "they overlap" : "a gap",
                kExportAgain);
    }
    end = range.end;
  }
  if (end != dataBytes) {
    failInput("{}: {} left over behind the last tensor; {}", name,
              counted(dataBytes - end, "byte is", "bytes are"), kExportAgain);
  }
}

}  // namespace

Container parseSafetensors(std::span<const std::byte> bytes, const std::string& name) {
  const std::string_view text = headerOf(bytes, name);
  const json header = parseHeader(text, name);
  const std::span<const std::byte> data = bytes.subspan(kLengthBytes + text.size());
  Container container;
  std::vector<Range> ranges;
  for (const auto& [key, value] : header.items()) {
    if (key == "__metadata__") {
      if (!value.is_object()) failInput("{}: __metadata__: is no object; {}", name, kExportAgain);
      container.metadata = value;
      continue;
    }
    Range range{.place = fmt::format("{}: tensor '{}'", name, shownText(key))};
    container.tensors.emplace(key, tensorOf(value, data, range));
    ranges.push_back(std::move(range));
  }
  checkRanges(std::move(ranges), data.size(), name);
  return container;
}

std::vector<float> valuesOf(const Tensor& tensor) {
  const std::size_t step = bytesOf(tensor.type);
  std::vector<float> values;
  values.reserve(tensor.bytes.size() / step);
  for (std::size_t at = 0; at < tensor.bytes.size(); at += step) {
    const auto bits = static_cast<std::uint32_t>(littleEndian(tensor.bytes.subspan(at, step)));
    values.push_back(tensor.type == ScalarType::F32
                         ? std::bit_cast<float>(bits)
                         : glm::unpackHalf1x16(static_cast<std::uint16_t>(bits)));
  }
  return values;
}

}  // namespace macula::network
