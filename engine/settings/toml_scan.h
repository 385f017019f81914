// A look over TOML text before toml++ parses it.
#pragma once

#include <string_view>

namespace macula::settings {

/// Refuses what toml++ 3.3 cannot take, and only that:
/// - keys of more than 32 parts. Tables are freed recursively, one stack frame a level, and
///   a.a.a.a... makes a level of each part; with the parser's own limit of 256 nested values this
///   bounds the depth to some thousands.
/// - characters beyond ASCII outside strings and comments, and quotes, brackets and equals signs in
///   the middle of a word, behind which the parser would take a string for more of that word (TOML
///   1.0 has neither), and the former right after a backslash: its test for blanks is undefined for
///   many of those characters.
/// - a heading without a name and brackets that do not match: it takes what stands there for a key
/// or
///   a value, and asserts.
/// Other mistakes are left to the parser.
/// @param name what to call the text in messages
/// @throws InputError "name:line: ..."
void scanToml(std::string_view text, std::string_view name);

}  // namespace macula::settings
