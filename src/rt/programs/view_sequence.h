// The views of a sequence of pictures, as they come in.
#pragma once

#include <cstdio>
#include <string>

#include "common/views/view.h"

namespace infra {

/// Reads lines such as "VIEW= -vp 1 2 3 -vd 0 1 0" or "rvu -vtv -vf start.vf -vh 30": each changes what it
/// mentions of the view before it. Lines that hold no view are passed over, as RADIANCE does.
class ViewSequence {
  public:
    /// input: stays open and the caller's. first: what the first line changes, set up.
    ViewSequence(std::FILE* input, std::string name, const View& first)
        : input_(input), name_(std::move(name)), view_(first), previous_(first) {}

    /// Reads on to the next view, and waits for it if it must. False at the end of input.
    ///   throws  Error with the line for a view line without options, with one misspelt or lacking numbers,
    ///           and for an illegal view; Error "interrupted" after a signal
    bool next();

    const View& view() const { return view_; }          ///< set up
    const View& previous() const { return previous_; }  ///< the one before, set up

  private:
    bool read_line(std::string& line);
    void change_view(const std::string& line);

    std::FILE* input_;
    std::string name_;
    int line_number_ = 0;
    View view_, previous_;
};

}  // namespace infra
