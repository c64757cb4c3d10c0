// The files, commands and streams that records go to.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rt/programs/rcontrib/record_format.h"

namespace infra {

class ContributionOutputs {
  public:
    /// Opens nothing yet.
    ///   header_start  first lines of every header, each with its line end; empty without headers
    ///   channels      as the scene has them
    ContributionOutputs(const RcontribSettings& settings, std::vector<OutputTarget> targets,
                        std::string header_start, const Channels& channels);
    ContributionOutputs(const ContributionOutputs&) = delete;
    ContributionOutputs& operator=(const ContributionOutputs&) = delete;
    ~ContributionOutputs();

    const std::vector<OutputTarget>& targets() const { return targets_; }
    const RecordFormat& format() const { return format_; }

    /// Writes what a RecordFormat has made of one or more records. Outputs are opened, and get their headers,
    /// at the first call.
    ///   texts   one a target
    ///   throws  Error when an output cannot be opened or written
    void write(std::span<const std::string> texts);
    void flush();
    /// Waits for commands. throws Error when one of them, or the last bytes of a file, went wrong.
    void close();

    /// -r: finds how many records all files have, and makes ready to go on behind them.
    ///   returns  0: nothing is there, and the files begin anew
    ///   throws   Error for text, other outputs than files, and files of another kind
    std::uint64_t resume(const WarningSink& warn);
    /// -r with -c 0: adds the values of the files to `sums`. False if there are none.
    bool reload(std::span<double> sums, const WarningSink& warn) const;

  private:
    void open();
    void open(std::size_t i);
    std::string header(const OutputTarget& target) const;
    std::string size_line(const OutputTarget& target) const;
    void check_recoverable(const OutputTarget& target) const;
    void skip_header(std::FILE* file, const OutputTarget& target) const;

    const RcontribSettings& settings_;
    std::vector<OutputTarget> targets_;
    std::string header_start_;
    std::string pixel_format_;
    RecordFormat format_;
    std::vector<std::FILE*> files_;  // as targets_, nullptr: not open
    bool opened_ = false;
};

}  // namespace infra
