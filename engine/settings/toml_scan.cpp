#include "engine/settings/toml_scan.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace macula::settings {
namespace {

constexpr int kMaxKeyParts = 32;

class Scanner {
 public:
  Scanner(std::string_view text, std::string_view name) : text_(text), name_(name) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  void scan() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (headingBegan() && c != ' ' && c != '\t') requireHeading(c);
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == '"' || c == '\'') {
        require(inKey_ ? keyMayGoOn() : valueMayBegin(), c);
        skipString(c);
        last_ = c;
      } else {
        step(c);
        if (!isBlank(c)) last_ = c;
        ++at_;
      }
    }
  }

 private:
  /// One character outside strings and comments.
  void step(char c) {
    switch (c) {
      case '\n':
        ++line_;
        if (open_.empty()) inKey_ = true;
        parts_ = 1;
        break;
      case '=':
        require(inKey_, c);
        inKey_ = false;
        parts_ = 1;
        break;
      case ',':
        inKey_ = !open_.empty() && open_.back() == '{';
        parts_ = 1;
        break;
      case '{':
        require(!inKey_ && valueMayBegin(), c);
        open_.push_back(c);
        inKey_ = true;
        parts_ = 1;
        break;
      case '[':
        headingBrackets_ = headingBegan() ? headingBrackets_ + 1 : 1;
        require(inKey_ ? last_ == '\n' || (last_ == '[' && headingBrackets_ <= 2) : valueMayBegin(),
                c);
        if (!inKey_) open_.push_back(c);  // otherwise a table's heading
        parts_ = 1;
        break;
      case ']':
      case '}':
        if (!open_.empty()) {
          require((c == ']') == (open_.back() == '['), c);
          open_.pop_back();
          inKey_ = false;
        }
        parts_ = 1;
        break;
      case '.':
        if (++parts_ > kMaxKeyParts) {
          failInput("{}:{}: a key of more than {} parts; shorten it", name_, line_, kMaxKeyParts);
        }
        break;
      default:
        if (static_cast<unsigned char>(c) > 0x7F) {
          failInput("{}:{}: a letter beyond ASCII outside quotes; put quotes around it", name_,
                    line_);
        }
        break;
    }
  }

  [[nodiscard]] static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  /// The last character was a bracket of a table's heading.
  [[nodiscard]] bool headingBegan() const { return inKey_ && open_.empty() && last_ == '['; }
  /// The parser takes whatever stands there for a key. Letters beyond ASCII are told of elsewhere.
  void requireHeading(char c) const {
    const auto byte = static_cast<unsigned char>(c);
    const bool bare = byte < 0x80 && std::isalnum(byte) != 0;
    if (!bare && byte < 0x80 && std::string_view("_-\"'[]").find(c) == std::string_view::npos) {
      failInput("{}:{}: no name after the bracket of a heading; write [name]", name_, line_);
    }
  }

  [[nodiscard]] bool valueMayBegin() const { return isOneOf("=[,\n"); }
  /// Where a quoted part of a key may begin: of a heading, of a table, or after a dot.
  [[nodiscard]] bool keyMayGoOn() const { return isOneOf("\n[{,."); }
  [[nodiscard]] bool isOneOf(std::string_view set) const {
    return set.find(last_) != std::string_view::npos;
  }

  void require(bool allowed, char c) const {
    if (!allowed) {
      failInput("{}:{}: {} where none can stand; check the quotes and signs of this line", name_,
                line_, c);
    }
  }

  void skipString(char quote) {
    const std::string fence(3, quote);
    const bool multiLine = text_.substr(at_, 3) == fence;
    at_ += multiLine ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!multiLine) return;  // unterminated: the parser will say so
        ++line_;
      }
      if (c == '\\' && quote == '"') refuseLetterAfterBackslash();
      if (c == '\\' && quote == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') {
        at_ += 2;
      } else if (!multiLine && c == quote) {
        ++at_;
        return;
      } else if (multiLine && text_.substr(at_, 3) == fence) {
        at_ += 3;
        // One or two quotes of the text may stand right before the closing three.
        for (int i = 0; i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
        return;
      } else {
        ++at_;
      }
    }
  }

  /// A backslash may stand before the blanks at a line's end, in which the parser looks for
  /// letters.
  void refuseLetterAfterBackslash() const {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", at_ + 1);
    if (next != std::string_view::npos && static_cast<unsigned char>(text_[next]) > 0x7F) {
      failInput("{}:{}: a letter beyond ASCII right after a backslash; put another one between",
                name_, line_);
    }
  }

  std::string_view text_;
  std::string_view name_;
  std::size_t at_ = 0;
  int line_ = 1;
  int parts_ = 1;            ///< of the key at this place
  int headingBrackets_ = 0;  ///< that open the heading at this place
  bool inKey_ = true;        ///< where a key may stand, not a value
  char last_ = '\n';         ///< last character that is no blank
  std::vector<char> open_;   ///< brackets of the value at this place
};

}  // namespace

void scanToml(std::string_view text, std::string_view name) {
  Scanner(text, name).scan();
}

}  // namespace macula::settings
