// xform's -a and -f: one command line that stands for many.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace infra::xform {

/// What a command line with -a and -f amounts to, in order.
struct RepetitionSink {
    std::function<void(std::vector<std::string> words)> call;  ///< a command line without them
    std::function<void(const std::string& line)> remark;       ///< an empty line or '#' line of a -f file
};

/// Takes the first -f (each line of a file, or of the standard input for "-", stands in its place) or else
/// the first -a (repeated 0, 1 .. n-1 times) apart, and so on until none is left. Each gets a name of its own
/// in -n.
///   throws  Error for a missing file or count, and for files that name one another without end
void for_each_call(const std::vector<std::string>& words, const RepetitionSink& sink);

}  // namespace infra::xform
