// printf into a std::string, for the texts whose form RADIANCE fixes ("%.7g", "%-9d").
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace infra {

/// As std::printf, but returns the text.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// The words of a text, separated by white space.
std::vector<std::string> split_words(std::string_view text);

/// One command line from its words, with quotes round a word that is empty or holds a blank or a quote, as
/// RADIANCE's headers have it.
std::string join_command(const std::vector<std::string>& words);

}  // namespace infra
