#include "engine/gaze/hid/descriptor.h"

#include <algorithm>
#include <optional>

#include "engine/core/error.h"
#include "engine/gaze/hid/item.h"

namespace macula::gaze::hid {
namespace {

/// Items that stay until they are replaced, kept by push and restored by pop (6.2.2.7).
struct GlobalState {
  std::uint16_t usagePage = 0;
  Item logicalMin;
  Item logicalMax;
  Item physicalMin;
  Item physicalMax;
  std::uint32_t unit = 0;
  int unitExponent = 0;
  std::uint32_t reportSize = 0;
  std::uint32_t reportCount = 0;
  std::uint8_t reportId = 0;
};

struct UsageRange {
  Item min;
  Item max;
};

/// Items that hold for the next main item alone (6.2.2.8).
struct LocalState {
  std::vector<UsageRange> usages;
  std::optional<Item> pendingMin;
  bool delimited = false;       ///< within a set of alternatives
  bool alternateTaken = false;  ///< its first, preferred usage has been seen
};

/// A bound is signed where the minimum is negative; otherwise a maximum of 0xFF in one byte is 255.
/// Decided when the field is made, so that the order of the two items does not matter.
Bounds boundsOf(const Item& min, const Item& max) {
  const std::int64_t low = min.signedData();
  return {low, low < 0 ? std::int64_t{max.signedData()} : std::int64_t{max.data}};
}

/// The exponent is a nibble in two's complement; some devices write a whole signed number instead.
int exponentOf(const Item& item) {
  constexpr std::uint32_t kNibble = 0xF;
  if (item.data <= kNibble) return static_cast<int>(item.data ^ 8U) - 8;
  return std::clamp(item.signedData(), -128, 127);
}

/// A usage of four bytes brings its page; a shorter one is of the page that holds at the main item.
Usage completeUsage(const Item& item, std::uint32_t id, std::uint16_t page) {
  return item.bytes == 4 ? id : (Usage{page} << 16) | (id & 0xFFFFU);
}

/// Hands out a main item's usages in order; the last one serves all further elements.
class UsageCursor {
 public:
  UsageCursor(const std::vector<UsageRange>& ranges, std::uint16_t page)
      : ranges_(ranges), page_(page) {}

  [[nodiscard]] Usage next() {
    const UsageRange& range = ranges_[range_];
    const std::uint32_t id = range.min.data + step_;
    if (id < range.max.data) {
      ++step_;
    } else if (range_ + 1 < ranges_.size()) {
      ++range_;
      step_ = 0;
    }
    return completeUsage(range.min, id, page_);
  }

 private:
  const std::vector<UsageRange>& ranges_;
  std::uint16_t page_;
  std::size_t range_ = 0;
  std::uint32_t step_ = 0;
};

class Parser {
 public:
  Parser(std::span<const std::uint8_t> bytes, std::string_view name)
      : name_(name), items_(bytes, name) {}

  Descriptor parse() {
    while (const auto item = items_.next()) {
      at_ = item->offset;
      switch (item->type) {
        case ItemType::Main:
          mainItem(*item);
          break;
        case ItemType::Global:
          globalItem(*item);
          break;
        case ItemType::Local:
          localItem(*item);
          break;
        case ItemType::Reserved:
          break;
      }
    }
    if (!open_.empty()) fail("a collection is never closed");
    const bool mixed = result_.numbered && unnumberedField_;
    if (mixed) fail("some reports have an id and some have none");
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(std::string_view reason) const {
    failInput("{}: report descriptor, byte {}: {}", name_, at_, reason);
  }

  void mainItem(const Item& item) {
    if (local_.delimited) fail("a delimiter is never closed");
    switch (item.tag) {
      case tag::kInput:
        addFields(ReportKind::Input, item.data);
        break;
      case tag::kOutput:
        addFields(ReportKind::Output, item.data);
        break;
      case tag::kFeature:
        addFields(ReportKind::Feature, item.data);
        break;
      case tag::kCollection:
        openCollection(item);
        break;
      case tag::kEndCollection:
        if (open_.empty()) fail("a collection ends that never began");
        open_.pop_back();
        break;
      default:
        break;
    }
    local_ = {};
  }

  void openCollection(const Item& item) {
    if (open_.size() >= kMaxCollectionDepth) fail("collections are nested too deeply");
    Collection collection{.type = static_cast<std::uint8_t>(item.data)};
    if (!local_.usages.empty())
      collection.usage = UsageCursor(local_.usages, now_.usagePage).next();
    collection.parent = innermost();
    result_.collections.push_back(collection);
    open_.push_back(static_cast<std::int32_t>(result_.collections.size()) - 1);
  }

  [[nodiscard]] std::int32_t innermost() const { return open_.empty() ? -1 : open_.back(); }

  ReportSize& sizeOf(ReportKind kind) {
    for (ReportSize& report : result_.reports) {
      if (report.kind == kind && report.reportId == now_.reportId) return report;
    }
    result_.reports.push_back({.kind = kind, .reportId = now_.reportId});
    return result_.reports.back();
  }

  void addFields(ReportKind kind, std::uint32_t flags) {
    ReportSize& report = sizeOf(kind);
    unnumberedField_ = unnumberedField_ || now_.reportId == 0;
    const std::uint64_t bits = std::uint64_t{now_.reportSize} * now_.reportCount;
    const std::uint32_t begin = report.bits;
    if (begin + bits > kMaxReportBytes * 8) fail("a report is longer than any device may send");
    report.bits += static_cast<std::uint32_t>(bits);
    if (bits == 0 || local_.usages.empty()) return;  // without a usage: padding
    if (now_.reportCount > kMaxFields - result_.fields.size()) fail("there are too many fields");

    Field field{.kind = kind,
                .reportId = now_.reportId,
                .bitOffset = begin,
                .bitSize = now_.reportSize,
                .flags = flags,
                .collection = innermost(),
                .logical = boundsOf(now_.logicalMin, now_.logicalMax),
                .physical = boundsOf(now_.physicalMin, now_.physicalMax),
                .unit = now_.unit,
                .unitExponent = now_.unitExponent};
    if (field.physical == Bounds{}) field.physical = field.logical;
    UsageCursor usages(local_.usages, now_.usagePage);
    for (std::uint32_t i = 0; i < now_.reportCount; ++i) {
      field.usage = usages.next();
      result_.fields.push_back(field);
      field.bitOffset += field.bitSize;
    }
  }

  void globalItem(const Item& item) {
    switch (item.tag) {
      case tag::kUsagePage:
        now_.usagePage = static_cast<std::uint16_t>(item.data);
        break;
      case tag::kLogicalMinimum:
        now_.logicalMin = item;
        break;
      case tag::kLogicalMaximum:
        now_.logicalMax = item;
        break;
      case tag::kPhysicalMinimum:
        now_.physicalMin = item;
        break;
      case tag::kPhysicalMaximum:
        now_.physicalMax = item;
        break;
      case tag::kUnitExponent:
        now_.unitExponent = exponentOf(item);
        break;
      case tag::kUnit:
        now_.unit = item.data;
        break;
      case tag::kReportSize:
        now_.reportSize = item.data;
        break;
      case tag::kReportId:
        if (item.data == 0 || item.data > 0xFF) fail("a report id is not within 1 to 255");
        now_.reportId = static_cast<std::uint8_t>(item.data);
        result_.numbered = true;
        break;
      case tag::kReportCount:
        now_.reportCount = item.data;
        break;
      case tag::kPush:
        if (pushed_.size() >= kMaxPushDepth) fail("push is nested too deeply");
        pushed_.push_back(now_);
        break;
      case tag::kPop:
        if (pushed_.empty()) fail("pop without a push");
        now_ = pushed_.back();
        pushed_.pop_back();
        break;
      default:
        break;
    }
  }

  void localItem(const Item& item) {
    switch (item.tag) {
      case tag::kDelimiter: {
        const bool opens = item.data != 0;
        if (opens == local_.delimited) fail("delimiters do not match");
        local_.delimited = opens;
        local_.alternateTaken = false;
        break;
      }
      case tag::kUsage:
        addUsages(item, item);
        break;
      case tag::kUsageMinimum:
        local_.pendingMin = item;
        break;
      case tag::kUsageMaximum:
        if (!local_.pendingMin) fail("a usage maximum without its minimum");
        if (item.data < local_.pendingMin->data) fail("a usage maximum below its minimum");
        addUsages(*local_.pendingMin, item);
        local_.pendingMin.reset();
        break;
      default:
        break;
    }
  }

  void addUsages(const Item& min, const Item& max) {
    if (local_.delimited && local_.alternateTaken) return;  // the first alternative is preferred
    local_.alternateTaken = true;
    local_.usages.push_back({min, max});
  }

  std::string_view name_;
  ItemReader items_;
  std::size_t at_ = 0;
  GlobalState now_;
  std::vector<GlobalState> pushed_;
  LocalState local_;
  std::vector<std::int32_t> open_;
  bool unnumberedField_ = false;
  Descriptor result_;
};

}  // namespace

bool Descriptor::isWithin(const Field& field, Usage collectionUsage) const {
  std::int32_t at = field.collection;
  while (at >= 0) {
    const Collection& collection = collections[static_cast<std::size_t>(at)];
    if (collection.usage == collectionUsage) return true;
    at = collection.parent;
  }
  return false;
}

std::size_t Descriptor::reportBytes(ReportKind kind, std::uint8_t reportId) const {
  for (const ReportSize& report : reports) {
    if (report.kind == kind && report.reportId == reportId) {
      return (numbered ? 1U : 0U) + (report.bits + 7U) / 8U;
    }
  }
  return 0;
}

Descriptor parseDescriptor(std::span<const std::uint8_t> bytes, std::string_view name) {
  if (bytes.size() > kMaxDescriptorBytes) {
    failInput("{}: report descriptor has {} bytes; at most {} are allowed", name, bytes.size(),
              kMaxDescriptorBytes);
  }
  return Parser(bytes, name).parse();
}

}  // namespace macula::gaze::hid
