#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace noonmark::cli {

/// Passes text on line by line as cleanLines() makes it: whatever a command prints of the names in a
/// stranger's file, it sends no commands to a terminal.
class CleanOutput : public std::streambuf {
public:
    explicit CleanOutput(std::ostream& out) : out_(out) {}
    ~CleanOutput() override;
    CleanOutput(const CleanOutput&) = delete;
    CleanOutput& operator=(const CleanOutput&) = delete;

private:
    int_type overflow(int_type letter) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;
    bool pass(std::size_t size);

    std::ostream& out_;
    std::string waiting_;  ///< the line that has not ended
};

}  // namespace noonmark::cli
